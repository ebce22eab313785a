// SPDX-License-Identifier: MIT
// Spectra, of lights and of surfaces, as linear RGB.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "penumbra/scene/material.h"

namespace penumbra {

/// What a spectrum is of. Light: its luminance is brought to 1, so that only the colour remains.
/// Surface: what it is under daylight (CIE D65), white being (1, 1, 1).
enum class SpectrumOf { light, surface };

struct SpectrumSample {
  double wavelength_nm = 0, value = 0;
};

/// Samples in order of their wavelengths, straight lines between them, the ends' values beyond.
/// Black where there is none. Colour matching by C. Wyman, P.-P. Sloan and P. Shirley, Simple
/// Analytic Approximations to the CIE XYZ Color Matching Functions, JCGT 2013. What lies outside
/// the colours of RGB is moved to their edge.
Color color_of_spectrum(const std::vector<SpectrumSample>& samples, SpectrumOf of);

/// A black body's light (Planck's law) of luminance 1. `kelvin` is at least 100.
Color color_of_blackbody(double kelvin);

/// The light of luminance 1 that has this chromaticity (CIE 1931 x and y > 0).
Color color_of_chromaticity(double x, double y);

/// CIE's standard illuminants by pbrt's names: stdillum-A, -D50, -D65, -F1 to -F12, illum-acesD60.
std::optional<Color> color_of_illuminant(std::string_view name);

/// The complex index of refraction of a metal at red, green and blue.
struct MetalIndex {
  Color eta, k;
};

/// By chemical symbol: Ag, Al, Au, Cu, CuZn (brass), MgO, TiO2.
std::optional<MetalIndex> metal_index(std::string_view symbol);

/// Of Schott's glasses, at 587.6 nm: BK7, BAF10, FK51A, LASF9, F5 (SF5), F10 (SF10), F11 (SF11).
std::optional<double> glass_index(std::string_view name);

/// What a metal mirrors of light that comes along the normal (Fresnel, from air).
Color metal_reflectance(const MetalIndex& index);

}  // namespace penumbra
