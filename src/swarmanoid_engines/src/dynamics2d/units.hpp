/// Box2D's units. Its tolerances are made for things of about a metre, and it stops fast bodies three slops deep in
/// each other; robots shall touch within half a millimetre, so Box2D gets all lengths 32 times as long. The factor is a
/// power of two: nothing is rounded by it. Slop is then 0.16 mm, the skin of polygons 0.31 mm.
#pragma once

#include <box2d/b2_common.h>
#include <box2d/b2_math.h>

#include <Eigen/Core>

namespace swarmanoid::dynamics2d {

constexpr double kUnitsPerMetre = 32.0;
constexpr double kSquareUnits = kUnitsPerMetre * kUnitsPerMetre;  ///< in a square metre

/// How deep Box2D lets bodies rest in each other [m].
constexpr double kSlop = static_cast<double>(b2_linearSlop) / kUnitsPerMetre;
/// The skin that Box2D has around polygons [m].
constexpr double kSkin = static_cast<double>(b2_polygonRadius) / kUnitsPerMetre;
/// What Box2D moves a body by in a step at most; it slows down what is faster [m].
constexpr double kLongestWay = static_cast<double>(b2_maxTranslation) / kUnitsPerMetre;

inline float toUnits(double metres) { return static_cast<float>(metres * kUnitsPerMetre); }
inline b2Vec2 toUnits(const Eigen::Vector2d& metres) { return {toUnits(metres.x()), toUnits(metres.y())}; }

inline double toMetres(float units) { return static_cast<double>(units) / kUnitsPerMetre; }
inline Eigen::Vector2d toMetres(const b2Vec2& units) { return {toMetres(units.x), toMetres(units.y)}; }

}  // namespace swarmanoid::dynamics2d
