// SPDX-License-Identifier: MIT
// Parameter lists of pbrt-v4's directives: "type name" value, or [ values ].
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/geometry/vec.h"
#include "penumbra/scene_io/pbrt_tokens.h"

namespace penumbra {

struct PbrtParameter {
  std::string type, name;
  std::vector<double> numbers;     ///< also of bools: 0 and 1
  std::vector<std::string> texts;  ///< of strings, textures, and spectra that are named
  PbrtPlace place;
};

/// The parameters of one directive. Where it does not have one, `defaults` (of the Attribute
/// directive) may. Remembers which were asked for.
class PbrtParams {
 public:
  /// Reads all parameters that follow. Throws Error for a type that pbrt does not have, for values
  /// that are not of the type, and for lists that are not closed.
  static PbrtParams read(PbrtTokens& tokens, PbrtPlace directive);

  /// These, and of the others those that these lack; of theirs nobody need ask for any. For
  /// Attribute, whose lists must be short: throws Error where they are not.
  PbrtParams with_defaults(const PbrtParams* others) const;
  void set_defaults(std::shared_ptr<const PbrtParams> defaults) { defaults_ = std::move(defaults); }

  /// Nothing where there is none of that name.
  const PbrtParameter* find(std::string_view name) const;
  bool has(std::string_view name) const { return find(name) != nullptr; }
  /// Whether it is the directive's own, not Attribute's.
  bool has_own(std::string_view name) const { return find_own(name) != nullptr; }

  // The value; `otherwise` where there is none of that name. Throw Error where it is of another
  // type or has another number of values.
  double number(std::string_view name, double otherwise) const;
  bool flag(std::string_view name, bool otherwise) const;
  std::string text(std::string_view name, std::string_view otherwise) const;
  Vec3d point(std::string_view name, Vec3d otherwise) const;
  // All values; none where there is no parameter of that name.
  std::vector<double> numbers(std::string_view name) const;
  std::vector<Vec3f> points(std::string_view name) const;
  std::vector<Vec2f> pairs(std::string_view name) const;
  std::vector<std::string> texts(std::string_view name) const;
  /// Whole numbers from 0 to below `end`; throws Error for others.
  std::vector<std::uint32_t> indices(std::string_view name, std::size_t end) const;

  /// Of the directive.
  PbrtPlace place() const { return place_; }
  /// Those that nobody has asked for.
  std::vector<const PbrtParameter*> unread() const;

 private:
  struct Entry {
    PbrtParameter parameter;
    mutable bool was_read = false;
  };
  const PbrtParameter* find_own(std::string_view name) const;

  std::vector<Entry> entries_;
  std::shared_ptr<const PbrtParams> defaults_;
  PbrtPlace place_;
};

}  // namespace penumbra
