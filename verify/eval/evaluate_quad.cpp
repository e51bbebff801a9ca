#include "reference/scalars.hpp"
#include "verify/eval/evaluate_in.hpp"

template tps::eval::Report tps::eval::evaluate_in<tps::Quad>(const Operation&, const Input&, std::string_view,
                                                             Detail);
