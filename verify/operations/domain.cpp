#include "verify/operations/domain.hpp"

namespace tps::operations {

Domain domain_of(std::string_view key) {
  if (key == "L" || key == "R_A" || key == "R_B") return Domain::length;
  if (key == "normal") return Domain::direction;
  if (key == "spin_A" || key == "spin_B") return Domain::spin;
  if (key == "gamma") return Domain::rate;
  if (key == "s" || key == "mu") return Domain::not_negative;
  if (key == "beta0") return Domain::signed_coefficient;
  if (key == "m_A" || key == "m_B" || key == "m") return Domain::mass;
  if (key == "theta_revolve_deg") return Domain::angle;
  if (key == "dt" || key == "i" || key == "j") return Domain::number;
  if (key == "c" || key == "c_retract" || key == "c_revolve") return Domain::coefficient;
  return Domain::vector;
}

}  // namespace tps::operations
