// Numbers that go where the trouble is: zeros, powers of two and their neighbours, ties, many decades. Every
// one is a number of the format.
#pragma once

#include <rapidcheck.h>

#include "properties/case.hpp"
#include "properties/format.hpp"

namespace tps::properties {

/// Above zero: 1, small integers, tenths, powers of two and the numbers next to them, of 2^-60 … 2^60 in
/// double (format.largest_case_exponent()).
rc::Gen<double> magnitude(const Format& format);

/// Zero, or a magnitude of either sign.
rc::Gen<double> number(const Format& format);

/// A small integer times a power of two: sums and products of these are often exact.
rc::Gen<double> small_integer();

/// In [0, 1], its ends as often as its inside.
rc::Gen<double> coefficient(const Format& format);

/// θ_revolve in [1°, 89°]; 45° and other round angles often.
rc::Gen<double> revolve_angle(const Format& format);

/// A mass of 30 decades (in double), equal and extreme ones often.
rc::Gen<double> finite_mass(const Format& format);

rc::Gen<Masses> masses(const Format& format);
rc::Gen<Masses> finite_masses(const Format& format);

/// A vector of number(), or of small integers. Planar ones have z = 0.
rc::Gen<Vec3> vector(const Format& format, int dimension);

}  // namespace tps::properties
