// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/PartColors.h"

#include <algorithm>
#include <cmath>

// Colours are chosen in CIE L*a*b*, where colours of equal lightness and distance from grey also look
// equally light and equally strong. Then they are converted by the definitions of CIE (white point D65)
// and of sRGB (IEC 61966-2-1).
namespace medial
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double goldenSection = 0.61803398874989485;
constexpr double chroma = 55;     ///< distance from grey
constexpr double firstHue = 0.12; ///< in turns
constexpr std::array<double, 3> lightnesses = { 66, 52, 78 };
constexpr std::array<double, 3> grey = { 0.75, 0.75, 0.75 };

/// The inverse of the function by which L*a*b* compresses the shares of the white point. No colour of
/// ours is so dark that its linear part, below 6 / 29, would be needed.
double expanded(double value)
{
  return value * value * value;
}

/// What a screen gets for an intensity of light.
double gammaCompressed(double intensity)
{
  return intensity > 0.0031308 ? 1.055 * std::pow(intensity, 1 / 2.4) - 0.055 : 12.92 * intensity;
}

/// A colour that a screen can't show is made darker until no component exceeds 1.
std::array<double, 3> shown(const std::array<double, 3>& rgb)
{
  const double scale = std::max(1.0, *std::max_element(rgb.begin(), rgb.end()));
  std::array<double, 3> result;
  std::transform(rgb.begin(), rgb.end(), result.begin(),
    [scale](double component) { return std::max(0.0, component / scale); });
  return result;
}

std::array<double, 3> rgbOfLab(double lightness, double a, double b)
{
  const double middle = (lightness + 16) / 116;
  const double x = 0.9505 * expanded(middle + a / 500);
  const double y = expanded(middle);
  const double z = 1.089 * expanded(middle - b / 200);
  return shown({ gammaCompressed(3.2406 * x - 1.5372 * y - 0.4986 * z),
    gammaCompressed(-0.9689 * x + 1.8758 * y + 0.0415 * z),
    gammaCompressed(0.0557 * x - 0.2040 * y + 1.0570 * z) });
}
}

std::array<double, 3> partColor(std::int64_t part)
{
  if (part < 0)
  {
    return grey;
  }
  // Multiples of the golden section fill the circle of hues evenly, however many parts there are.
  const double hue = 2 * pi * std::fmod(firstHue + part * goldenSection, 1.0);
  return rgbOfLab(lightnesses[part % 3], chroma * std::cos(hue), chroma * std::sin(hue));
}
}
