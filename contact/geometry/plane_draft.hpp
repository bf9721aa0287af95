#pragma once
/// The common plane of two simple faces in 3D while it is found, step by step, so that those of
/// several pairs can take the same step side by side.
#include "contact/geometry/overlap_push.hpp"

namespace brunt {

class PlaneDraft {
 public:
  Polygon below, above;  ///< corners in the plane, counter-clockwise: those of the upper run back
  LinearField penetration;  ///< [m]

  /// All outlive it. Normal, origin, axes, ramp and barrier of the plane are known, and so are
  /// outlines and penetration once the next step is taken.
  void begin(const FacePlane<3>& lower, const FacePlane<3>& upper, const PlaneNeeds& needs,
             CommonPlane<3>& plane) {
    lower_ = &lower, upper_ = &upper, needs_ = &needs, plane_ = &plane;
  }
  /// The area under pressure; false if it is none.
  bool find_overlap();
  /// The same where it is all of the lower face, as found elsewhere.
  void take_overlap(const FieldIntegrals& sum, Real deepest);
  /// Pressure and energy, and where it acts; false if it has faded.
  bool find_pressure();
  /// Where the push acts, and the middle of the area, in the axes of the plane [m].
  const Vec<2>& point() const { return point_; }
  const Vec<2>& middle() const { return middle_; }
  void set_weights();
  /// Beside its normal what follows the potential.
  void follow_potential();

 private:
  bool whole() const { return needs_->whole || needs_->at_point; }
  bool pushes() const { return needs_->pushes && !whole(); }
  OverlapArea overlap() const {
    return {below,           above, penetration,     sum_,         lower_->borders,
            upper_->borders, deep_, needs_->opening, needs_->limit};
  }

  const FacePlane<3>*lower_ = nullptr, *upper_ = nullptr;
  const PlaneNeeds* needs_ = nullptr;
  CommonPlane<3>* plane_ = nullptr;
  FieldIntegrals sum_;
  DeepArea deep_;
  BorderFade<3> fade_;
  Vec<2> point_ = Vec<2>::Zero(), middle_ = Vec<2>::Zero();
};

}  // namespace brunt
// Tested by tests/unit/contact/common_plane_test.cpp.
