#include "reference/scalars.hpp"
#include "verify/eval/evaluate_in.hpp"

template tps::eval::Report tps::eval::evaluate_in<tps::Mp50>(const Operation&, const Input&, std::string_view,
                                                             Detail);
