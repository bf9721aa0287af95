#pragma once
/// What is allowed and hardly meant: reported in warnings, with what was probably meant.
#include <functional>
#include <string>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// Called with the path of a key and what is to be said of it.
using Warn = std::function<void(const std::string& path, const std::string& what)>;

/// Elements larger than their body, surfaces of files in other units than the scene, probes and
/// points of measures far from their bodies, and heat that is passed where nothing conducts. Of a
/// whole scene at time 0.
template <int Dim>
void warn_of_sizes(const LoadedDeck& loaded, const Scene<Dim>& scene, const Warn& warn);

/// Bodies that move and in a straight line meet nothing until the end: boxes swept by the velocity
/// at time 0. Only bodies that follow such a line: without gravity, forces, or velocities that are
/// prescribed.
template <int Dim>
void warn_of_missed_aims(const LoadedDeck& loaded, const Scene<Dim>& scene, const Warn& warn);

/// Bounding box [m] of the points of a body at time 0; empty: low above high.
template <int Dim>
struct BodyBox {
  Vec<Dim> low = Vec<Dim>::Constant(kInfinity), high = Vec<Dim>::Constant(-kInfinity);
  Vec<Dim> lengths() const { return high - low; }
  bool empty() const { return low[0] > high[0]; }
  void add(const BodyBox& other) {
    low = low.cwiseMin(other.low), high = high.cwiseMax(other.high);
  }
  /// The vector [m] by which another box is apart, 0 along axes where they overlap.
  Vec<Dim> gap(const BodyBox& other) const {
    return (low - other.high).cwiseMax(other.low - high).cwiseMax(Vec<Dim>::Zero());
  }
};

/// Of each body, absolute.
template <int Dim>
std::vector<BodyBox<Dim>> boxes_of_bodies(const Scene<Dim>& scene);

}  // namespace brunt
