// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra {
namespace {

constexpr double first_nm = 380, last_nm = 780, step_nm = 5;

/// Relative power of CIE D65 from 380 nm in steps of 10 nm (CIE 15, table T.1).
constexpr std::array d65{49.98,  54.65,  82.75,  91.49,  93.43,  86.68,  104.86, 117.01, 117.81,
                         114.86, 115.92, 108.81, 109.35, 107.80, 104.79, 107.69, 104.41, 104.05,
                         100.00, 96.33,  95.79,  88.69,  90.01,  89.60,  87.70,  83.29,  83.70,
                         80.03,  80.21,  82.28,  78.28,  69.72,  71.61,  74.35,  61.60,  69.89,
                         75.09,  63.59,  46.42,  66.81,  63.38};

double daylight(double wavelength_nm) {
  const double at = (wavelength_nm - first_nm) / 10;
  const auto i = std::min(static_cast<std::size_t>(at), d65.size() - 2);
  const double share = at - static_cast<double>(i);
  return d65[i] * (1 - share) + d65[i + 1] * share;
}

double lobe(double wavelength_nm, double center, double below, double above) {
  const double x = (wavelength_nm - center) / (wavelength_nm < center ? below : above);
  return std::exp(-0.5 * x * x);
}

/// The colour matching functions.
Vec3d xyz_at(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

/// To linear RGB of Rec. 709's primaries and white D65 (IEC 61966-2-1).
Vec3d rgb_of(Vec3d xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

/// The integral over what is seen.
template <typename Spectrum>
Vec3d xyz_of(const Spectrum& value_at) {
  Vec3d sum;
  for (double nm = first_nm; nm <= last_nm; nm += step_nm) sum += xyz_at(nm) * value_at(nm);
  return sum;
}

Color light_color(Vec3d xyz) {
  if (!(xyz.y > 0) || !is_finite(xyz)) return {};
  return max(Color(rgb_of(xyz / xyz.y)), Color{});
}

struct Interpolated {
  const std::vector<SpectrumSample>& samples;

  double operator()(double nm) const {
    const auto above =
        std::lower_bound(samples.begin(), samples.end(), nm,
                         [](const SpectrumSample& s, double at) { return s.wavelength_nm < at; });
    if (above == samples.begin()) return samples.front().value;
    if (above == samples.end()) return samples.back().value;
    const SpectrumSample& a = above[-1];
    const double share = (nm - a.wavelength_nm) / (above->wavelength_nm - a.wavelength_nm);
    return a.value + (above->value - a.value) * share;
  }
};

struct Chromaticity {
  std::string_view name;
  double x, y;
};

// CIE 15:2004, tables T.3 and T.7; D60 as in SMPTE ST 2065-1.
constexpr Chromaticity illuminants[] = {
    {"stdillum-A", 0.4476, 0.4074},   {"stdillum-D50", 0.3457, 0.3585},
    {"stdillum-D65", 0.3127, 0.3290}, {"illum-acesD60", 0.32168, 0.33767},
    {"stdillum-F1", 0.3131, 0.3371},  {"stdillum-F2", 0.3721, 0.3751},
    {"stdillum-F3", 0.4091, 0.3941},  {"stdillum-F4", 0.4402, 0.4031},
    {"stdillum-F5", 0.3138, 0.3452},  {"stdillum-F6", 0.3779, 0.3882},
    {"stdillum-F7", 0.3129, 0.3292},  {"stdillum-F8", 0.3458, 0.3586},
    {"stdillum-F9", 0.3741, 0.3727},  {"stdillum-F10", 0.3458, 0.3588},
    {"stdillum-F11", 0.3805, 0.3769}, {"stdillum-F12", 0.4370, 0.4042}};

struct Metal {
  std::string_view symbol;
  MetalIndex index;
};

// Ag, Al, Au, Cu: E. D. Palik, Handbook of Optical Constants of Solids (1985), weighted with the
// eye's sensitivity to red, green and blue; brass and the oxides: the same at 630, 532 and 465 nm.
constexpr Metal metals[] = {{"Ag", {{0.155f, 0.117f, 0.138f}, {4.828f, 3.122f, 2.147f}}},
                            {"Al", {{1.657f, 0.880f, 0.521f}, {9.224f, 6.270f, 4.837f}}},
                            {"Au", {{0.143f, 0.375f, 1.442f}, {3.983f, 2.386f, 1.603f}}},
                            {"Cu", {{0.200f, 0.924f, 1.102f}, {3.913f, 2.453f, 2.142f}}},
                            {"CuZn", {{0.444f, 0.527f, 1.094f}, {3.695f, 2.765f, 1.829f}}},
                            {"MgO", {{1.735f, 1.740f, 1.748f}, {}}},
                            {"TiO2", {{2.58f, 2.66f, 2.77f}, {}}}};

struct Glass {
  std::string_view name;
  double index;
};

// Schott's catalogue, n_d.
constexpr Glass glasses[] = {{"BK7", 1.5168},   {"BAF10", 1.6700}, {"FK51A", 1.4866},
                             {"LASF9", 1.8503}, {"F5", 1.6727},    {"F10", 1.7283},
                             {"F11", 1.7847}};

}  // namespace

Color color_of_spectrum(const std::vector<SpectrumSample>& samples, SpectrumOf of) {
  if (samples.empty()) return {};
  const Interpolated value_at{samples};
  if (of == SpectrumOf::light) return light_color(xyz_of(value_at));
  const Vec3d seen = rgb_of(xyz_of([&](double nm) { return value_at(nm) * daylight(nm); }));
  const Vec3d white = rgb_of(xyz_of(daylight));
  return max(Color(Vec3d(seen.x / white.x, seen.y / white.y, seen.z / white.z)), Color{});
}

Color color_of_blackbody(double kelvin) {
  constexpr double second_radiation_constant = 1.438777e7;  // h c / k, in nm K
  const double hottest = std::max(kelvin, 100.0);
  // Relative to 560 nm, so that cold bodies' tiny numbers do not vanish.
  const auto power = [&](double nm) {
    const double exponent = second_radiation_constant / hottest * (1 / nm - 1 / 560.0);
    const double scale = -std::expm1(-second_radiation_constant / (560 * hottest)) /
                         -std::expm1(-second_radiation_constant / (nm * hottest));
    return std::pow(560 / nm, 5) * std::exp(-exponent) * scale;
  };
  return light_color(xyz_of(power));
}

Color color_of_chromaticity(double x, double y) { return light_color({x / y, 1, (1 - x - y) / y}); }

std::optional<Color> color_of_illuminant(std::string_view name) {
  for (const Chromaticity& illuminant : illuminants)
    if (illuminant.name == name) return color_of_chromaticity(illuminant.x, illuminant.y);
  return std::nullopt;
}

std::optional<MetalIndex> metal_index(std::string_view symbol) {
  for (const Metal& metal : metals)
    if (metal.symbol == symbol) return metal.index;
  return std::nullopt;
}

std::optional<double> glass_index(std::string_view name) {
  for (const Glass& glass : glasses)
    if (glass.name == name) return glass.index;
  return std::nullopt;
}

Color metal_reflectance(const MetalIndex& index) {
  const auto reflected = [](float eta, float k) {
    const double n = eta, k2 = static_cast<double>(k) * static_cast<double>(k);
    const double sum = (n + 1) * (n + 1) + k2;
    return static_cast<float>(std::isfinite(sum) ? ((n - 1) * (n - 1) + k2) / sum : 1);
  };
  return {reflected(index.eta.x, index.k.x), reflected(index.eta.y, index.k.y),
          reflected(index.eta.z, index.k.z)};
}

}  // namespace penumbra
