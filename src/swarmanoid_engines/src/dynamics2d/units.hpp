/// Box2D's units. Its tolerances (slop, polygon skin, margins of boxes) are made for things of about a metre; robots
/// are a tenth of that, so Box2D gets all lengths eight times as long. The factor is a power of two: nothing is rounded
/// by it. Slop is then 0.6 mm, the skin of polygons 1.25 mm.
#pragma once

#include <box2d/b2_math.h>

#include <Eigen/Core>

namespace swarmanoid::dynamics2d {

constexpr double kUnitsPerMetre = 8.0;
constexpr double kSquareUnits = kUnitsPerMetre * kUnitsPerMetre;  ///< in a square metre

inline float toUnits(double metres) { return static_cast<float>(metres * kUnitsPerMetre); }
inline b2Vec2 toUnits(const Eigen::Vector2d& metres) { return {toUnits(metres.x()), toUnits(metres.y())}; }

inline double toMetres(float units) { return static_cast<double>(units) / kUnitsPerMetre; }
inline Eigen::Vector2d toMetres(const b2Vec2& units) { return {toMetres(units.x), toMetres(units.y)}; }

}  // namespace swarmanoid::dynamics2d
