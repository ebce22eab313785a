// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/write_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <utility>

#include "penumbra/scene/error.h"
#include "penumbra/scene/image.h"
#include "penumbra/scene_io/npy_header.h"

namespace penumbra {
namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they lie");

template <typename Value>
void append(std::string& out, const Value* values, std::size_t count) {
  const std::size_t used = out.size();
  out.resize(used + count * sizeof(Value));
  std::memcpy(out.data() + used, values, count * sizeof(Value));
}

/// 0 lit, 1 penumbra, 2 umbra.
float share_of_class(std::uint8_t light_class) {
  return 1 - 0.5f * static_cast<float>(std::min<std::uint8_t>(light_class, 2));
}

/// The shortest text that reads back to the same float.
void append_text(std::string& out, float value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  out.append(text.data(), end);
}

void append_text(std::string& out, Vec3f v, char separator) {
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) out += separator;
    append_text(out, v[axis]);
  }
}

bool has_count(AnswerFormat format) {
  return format == AnswerFormat::npy || format == AnswerFormat::ply;
}

}  // namespace

AnswerWriter::AnswerWriter(const std::filesystem::path& path, AnswerLayout layout)
    : layout_(std::move(layout)), file_(path) {
  if (has_count(layout_.format) && file_.temporary().empty())
    throw Error({path == "-" ? "standard output" : path.string(), {}, {}},
                "NPY and PLY begin with the number of points, which is known at the end",
                "write them to a file with -o");
  file_.write(header());
}

/// As long for any number of points.
std::string AnswerWriter::header() const {
  const std::size_t lights = layout_.lights;
  switch (layout_.format) {
    case AnswerFormat::csv: {
      std::string names = layout_.has_normals ? "x,y,z,nx,ny,nz" : "x,y,z";
      for (std::size_t i = 0; i < lights; ++i) {
        if (layout_.has_classes) names += fmt::format(",class_light{}", i);
        if (layout_.has_fractions) names += fmt::format(",visibility_light{}", i);
      }
      return names + "\n";
    }
    case AnswerFormat::npy: {
      if (layout_.has_classes && layout_.has_fractions)
        return npy_header(
            fmt::format("[('class', '|u1', ({0},)), ('visibility', '<f4', ({0},))]", lights),
            points_, 0);
      return npy_header(layout_.has_classes ? "'|u1'" : "'<f4'", points_, lights);
    }
    case AnswerFormat::ply: return ply_header();
    case AnswerFormat::ascii:
    case AnswerFormat::float32:
    case AnswerFormat::float64: break;
  }
  return {};
}

std::string AnswerWriter::ply_header() const {
  std::string out = "ply\nformat binary_little_endian 1.0\n";
  const std::string count = std::to_string(points_);
  out += "comment written by penumbra" + std::string(20 - count.size(), ' ') + "\n";
  out += "element vertex " + count + "\n";
  for (const char* name : {"x", "y", "z"}) out += fmt::format("property float {}\n", name);
  if (layout_.has_normals)
    for (const char* name : {"nx", "ny", "nz"}) out += fmt::format("property float {}\n", name);
  for (const char* name : {"red", "green", "blue"}) out += fmt::format("property uchar {}\n", name);
  for (std::size_t i = 0; i < layout_.lights; ++i) {
    if (layout_.has_classes) out += fmt::format("property uchar class_light{}\n", i);
    if (layout_.has_fractions) out += fmt::format("property float visibility_light{}\n", i);
  }
  return out + "end_header\n";
}

void AnswerWriter::append_text(const PointBlock& points, const AnswerBlock& answers) {
  const bool is_csv = layout_.format == AnswerFormat::csv;
  const char separator = is_csv ? ',' : '\t';
  for (std::size_t i = 0, k = 0; i < points.positions.size(); ++i) {
    if (is_csv) {
      penumbra::append_text(bytes_, points.positions[i], separator);
      bytes_ += separator;
      if (layout_.has_normals) {
        penumbra::append_text(bytes_, points.normals[i], separator);
        bytes_ += separator;
      }
    }
    for (std::size_t light = 0; light < layout_.lights; ++light, ++k) {
      if (light > 0) bytes_ += separator;
      if (layout_.has_classes)
        bytes_ += is_csv ? layout_.class_names.at(answers.classes[k])
                         : std::to_string(answers.classes[k]);
      if (layout_.has_classes && layout_.has_fractions) bytes_ += separator;
      if (layout_.has_fractions) penumbra::append_text(bytes_, answers.fractions[k]);
    }
    bytes_ += '\n';
  }
}

void AnswerWriter::append_npy(const AnswerBlock& answers) {
  const std::size_t lights = layout_.lights;
  if (!layout_.has_classes) {
    append(bytes_, answers.fractions.data(), answers.fractions.size());
  } else if (!layout_.has_fractions) {
    append(bytes_, answers.classes.data(), answers.classes.size());
  } else {
    for (std::size_t k = 0; k < answers.classes.size(); k += lights) {
      append(bytes_, &answers.classes[k], lights);
      append(bytes_, &answers.fractions[k], lights);
    }
  }
}

void AnswerWriter::append_ply(const PointBlock& points, const AnswerBlock& answers) {
  const std::size_t lights = layout_.lights;
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    append(bytes_, &points.positions[i], 1);
    if (layout_.has_normals) append(bytes_, &points.normals[i], 1);
    float sum = 0;
    for (std::size_t k = i * lights; k < (i + 1) * lights; ++k)
      sum += layout_.has_fractions ? answers.fractions[k] : share_of_class(answers.classes[k]);
    const std::uint8_t grey = srgb_from_linear(sum / static_cast<float>(lights));
    bytes_.append(3, static_cast<char>(grey));
    for (std::size_t k = i * lights; k < (i + 1) * lights; ++k) {
      if (layout_.has_classes) append(bytes_, &answers.classes[k], 1);
      if (layout_.has_fractions) append(bytes_, &answers.fractions[k], 1);
    }
  }
}

/// Fractions, or classes as numbers.
void AnswerWriter::append_numbers(const AnswerBlock& answers) {
  const auto append_all = [&](const auto& values) {
    for (const auto value : values) {
      const auto number = static_cast<float>(value);
      const auto wide = static_cast<double>(value);
      if (layout_.format == AnswerFormat::float32)
        append(bytes_, &number, 1);
      else
        append(bytes_, &wide, 1);
    }
  };
  if (layout_.has_fractions)
    append_all(answers.fractions);
  else
    append_all(answers.classes);
}

void AnswerWriter::write(const PointBlock& points, const AnswerBlock& answers) {
  bytes_.clear();
  switch (layout_.format) {
    case AnswerFormat::csv:
    case AnswerFormat::ascii: append_text(points, answers); break;
    case AnswerFormat::npy: append_npy(answers); break;
    case AnswerFormat::ply: append_ply(points, answers); break;
    case AnswerFormat::float32:
    case AnswerFormat::float64: append_numbers(answers); break;
  }
  points_ += points.positions.size();
  file_.write(bytes_);
}

void AnswerWriter::finish() {
  if (has_count(layout_.format)) file_.rewrite_start(header());
  file_.finish();
}

}  // namespace penumbra
