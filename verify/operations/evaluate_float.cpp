#include "verify/operations/evaluate_in.hpp"

template tps::operations::Report tps::operations::evaluate_in<float>(const Operation&, const Input&,
                                                                     std::string_view, Detail);
