// Numbers that go where the trouble is: zeros, powers of two and their neighbours, ties, many decades.
#pragma once

#include <rapidcheck.h>

namespace tps::properties {

/// Zero, or of magnitude 2^-60 … 2^60, so that no product of six of them leaves the range of double.
rc::Gen<double> number();

/// In [0, 1], its ends as often as its inside.
rc::Gen<double> coefficient();

/// θ_revolve in [1°, 89°]; 45° and other round angles often.
rc::Gen<double> revolve_angle();

/// A mass of 1e-9 … 1e9, equal and extreme ones often.
rc::Gen<double> finite_mass();

/// The same, or infinite.
rc::Gen<double> mass();

/// Two masses of which at most one is infinite.
struct Masses {
  double A, B;
};
rc::Gen<Masses> masses();
rc::Gen<Masses> finite_masses();

}  // namespace tps::properties
