/// Paint on the floor, which fades: marks that robots leave for others (stigmergy, thesis chapter 1). A grid of square
/// cells covers the arena; each cell has a colour, and a strength between 0 (transparent) and 1 (opaque).
///
/// Units   [m] in frame W, ticks.
/// Law     paint of strength a over paint of strength s has the strength a + s (1 - a), and the mean of both colours
///         with the weights a and s (1 - a). A strength is halved each half-life: after n ticks it is s 2^(-n /
///         half-life). The visible colour is that of the floor plus the strength times the difference; for strengths
///         below 1/512 it is that of the floor.
/// Cost    a tick costs nothing: cells store the tick in which they were painted, and a query computes the current
///         strength.
/// Phase   painted between ticks, read in all phases.
/// Threads const functions may run concurrently.
/// Bits    the strength after n ticks is a product of at most 64 factors in a fixed order.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/state_archive.hpp"

namespace swarmanoid {

/// A disc of paint.
struct PaintDisc {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of its centre [m]
  double radius = 0.0;                                 ///< of the disc [m]; 0: one cell
  Color color;
  double strength = 1.0;  ///< greater than 0, up to 1
};

/// The layer's settings in an experiment file.
struct PaintDescription {
  double cell = 0.0;       ///< side of a cell [m]
  double half_life = 0.0;  ///< [s]; 0: it does not fade
};

class PaintLayer {
 public:
  static constexpr std::size_t kMostCells = std::size_t{1} << 24;

  /// A layer without cells: nothing can be painted.
  PaintLayer() = default;
  /// A layer without paint. @param size of the arena [m] @param cell its side [m]
  /// @param half_life [ticks]; 0: no fading
  /// @param corner of the arena, with its least coordinates [m] @pre there are at most kMostCells
  PaintLayer(const Eigen::Vector2d& size, double cell, double half_life,
             const Eigen::Vector2d& corner = Eigen::Vector2d::Zero());

  /// Number of cells that a layer would have, without an upper limit.
  static double cellsFor(const Eigen::Vector2d& size, double cell);

  bool exists() const { return !cells_.empty(); }
  /// Paints the cells whose centres are in the disc; if there are none, the one below the disc's centre.
  /// @pre the layer exists, and the centre is in the arena @param tick the next tick
  void paint(const PaintDisc& disc, std::uint64_t tick);
  /// Number of cells that `paint` tests: those of the square around the disc that are in the arena. @pre as for `paint`
  std::size_t cellsAround(const PaintDisc& disc) const;

  /// The visible colour at a point. @param floor colour below the paint @param tick current tick
  Color over(Color floor, const Eigen::Vector2d& point, std::uint64_t tick) const {
    return painted_.empty() ? floor : blend(floor, point, tick);
  }

  /// A painted cell and its current strength.
  struct Spot {
    Eigen::Vector2d position;  ///< of its centre [m]
    Color color;
    double strength;  ///< 0: invisible
  };
  double cellSize() const { return cell_size_; }
  /// All cells ever painted, in the order of their first painting. @{
  std::size_t spotCount() const { return painted_.size(); }
  Spot spot(std::size_t number, std::uint64_t tick) const;
  /// @}
  int columnOf(std::size_t number) const { return static_cast<int>(painted_[number] % columns_); }
  int rowOf(std::size_t number) const { return static_cast<int>(painted_[number] / columns_); }

  /// A digest of all painted cells and their ticks. Equal for layers with the same cells; different layers have equal
  /// digests with a probability of 1 in 2^64.
  std::uint64_t digest() const { return digest_; }

  /// Saves or loads the paint, for snapshots; loads into a layer of the same size. Takes time for each painted cell.
  void archive(StateArchive& state);

 private:
  struct Cell {
    std::uint64_t tick = 0;  ///< in which it had the strength
    float strength = 0.0F;   ///< 0: never painted
    Color color;
  };

  /// The cells of the square around a disc that lie in the arena; the last ones included.
  struct Square {
    std::size_t first_column, last_column, first_row, last_row;
  };
  Square squareAround(const PaintDisc& disc) const;
  std::size_t columnAt(double x) const;
  std::size_t rowAt(double y) const;
  Color blend(Color floor, const Eigen::Vector2d& point, std::uint64_t tick) const;
  double strengthOf(const Cell& cell, std::uint64_t tick) const;
  void paintCell(std::size_t index, const PaintDisc& disc, std::uint64_t tick);

  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d size_ = Eigen::Vector2d::Zero();
  double cell_size_ = 0.0;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::uint64_t vanishes_after_ = 0;    ///< [ticks]; 0: never
  std::array<double, 64> fade_{};       ///< remaining part of 1 after 1, 2, 4, ... ticks
  std::vector<Cell> cells_;             ///< row after row from the smallest y
  std::vector<std::uint32_t> painted_;  ///< indices of cells
  std::uint64_t digest_ = 0;
};

}  // namespace swarmanoid
