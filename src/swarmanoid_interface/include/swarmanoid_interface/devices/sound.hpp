/// The propagation of sound, for all microphones of the suite.
#pragma once

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/range.hpp"

namespace swarmanoid {

/// Sound in free field: no echoes, no wind, no delay. It spreads evenly in all directions, so the mean square of its
/// pressure falls with the square of the distance, by 6.02 dB for each doubling (ISO 9613-2:1996, 7.1, geometrical
/// divergence of a point source). Incoherent sources add by their mean squares (the same, equation 5). Absorption by
/// the air is neglected; at 20 C it would be 0.02 dB/m at 4 kHz and 0.08 dB/m at 8 kHz (the same, table 2).
struct Sound {
  static constexpr Range kLevels{0.0, 140.0};          ///< of sources [dB re 20 uPa at 1 m]; 0: silent
  static constexpr Range kFrequencies{20.0, 20000.0};  ///< audible [Hz]
  static constexpr double kClosest = 0.01;             ///< smaller distances count as this [m]
  static constexpr double kUsualRange = 5.0;           ///< maximum distance of a source [m]
  static constexpr double kUsualBackground = 30.0;     ///< the sound pressure level of a quiet room [dB re 20 uPa]

  /// The mean square of the pressure, in units of that of 20 uPa. @param level [dB re 20 uPa]
  static double power(double level) { return std::pow(10.0, 0.1 * level); }
  /// The inverse [dB re 20 uPa].
  static double level(double power) { return 10.0 * std::log10(power); }
  /// The fraction of the power at 1 m that arrives. @param squared_distance from the source [m2]
  static double spread(double squared_distance) { return 1.0 / std::max(squared_distance, kClosest * kClosest); }
};

}  // namespace swarmanoid
