#include "verify/operations/evaluate_in.hpp"

template tps::operations::Report tps::operations::evaluate_in<double>(const Operation&, const Input&,
                                                                      std::string_view, Detail);
