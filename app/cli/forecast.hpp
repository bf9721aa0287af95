#pragma once
#include "app/deck/deck.hpp"

namespace brunt {

/// How far impacts may flatten elements; a plan knows no more.
struct Flattening {
  Real speed = 0;   ///< [m/s] the largest between two bodies
  Real strain = 0;  ///< [1] mean compression of the body that yields most to it
  /// Up to so many times the steps that elements of unchanged shape take. A step is as long as the
  /// thinnest element is thick, exp(-strain), and a struck face is compressed several times as far
  /// as the body: 5.3 times in a Taylor bar (taylor-bar-axisymmetric: 17.2 times the steps at a
  /// mean strain of 0.54).
  Real most_steps() const;
};

/// Of the bodies that deform. The strain stops a body at that speed:
///   int_0^strain flow stress = rho v^2 / 2, or v/c where it does not yield
Flattening flattening_of(const Deck& deck);

}  // namespace brunt
