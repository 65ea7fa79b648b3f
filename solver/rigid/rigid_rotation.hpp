#pragma once

#include <Eigen/Geometry>
#include <span>

/// How a rigid body turns in a step in which its angular momentum L stays, or about given axes.
namespace pinball {

/// Free rotation over dt: the orientation afterwards.
///
/// In the axes of the body, Pi = R^T L and Euler's equations dPi/dt = Pi x J^-1 Pi, a substep of length h is
///
///     Pi_1 = Pi_0 + h P x W ,   R_1 = R_0 cay(h W) ,   P = (Pi_0 + Pi_1)/2 ,   W = J^-1 P ,
///
/// cay(w) = (1 - w/2)^-1 (1 + w/2) with the skew tensor of w: both energy and momentum are kept, whatever h is (Simo
/// and Wong, Int. J. Num. Meth. Engrg. 31, 19-52, 1991, ALGO_C1). Three substeps of 1.35, -1.70 and 1.35 dt make the
/// error of fourth order in dt |w| (Yoshida, Phys. Lett. A 150, 262-268, 1990). inertia: J, in the axes of the body
/// [mass length^2]; momentum: L [mass length^2/time]
Eigen::Quaterniond turned_freely(const Eigen::Quaterniond& orientation, const Eigen::Matrix3d& inertia,
                                 const Eigen::Vector3d& momentum, double dt);

/// Axes fixed in space about which rates of rotation are given.
struct GivenAxes {
  int count = 0;                                        ///< none to three
  Eigen::Matrix3d basis = Eigen::Matrix3d::Identity();  ///< orthonormal columns, the given axes first
};
GivenAxes axes_of(std::span<const Eigen::Vector3d> orthonormal);

/// The motion x with the given rates along the axes and, across them, m . x = load, m being a mass or inertia in space:
/// a velocity for a momentum, an acceleration for a force. rates: as many as there are axes, then anything.
Eigen::Vector3d motion_with(const GivenAxes& axes, const Eigen::Vector3d& rates, const Eigen::Matrix3d& m,
                            const Eigen::Vector3d& load);

/// The same as a tensor, for rates of zero: I^-1 - I^-1 H (H^T I^-1 H)^-1 H^T I^-1 of axes H, symmetric.
Eigen::Matrix3d mobility_across(const GivenAxes& axes, const Eigen::Matrix3d& m);

/// Rotation over dt with given rates about some axes, and the momentum kept across them: the midpoint rule, of second
/// order; exact about one axis, where two others are held, and where all rates are given.
Eigen::Quaterniond turned_about(const GivenAxes& axes, const Eigen::Vector3d& rates,
                                const Eigen::Quaterniond& orientation, const Eigen::Matrix3d& inertia,
                                const Eigen::Vector3d& momentum, double dt);

}  // namespace pinball
