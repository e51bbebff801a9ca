#include "reference/scalars.hpp"
#include "verify/operations/evaluate_in.hpp"

template tps::operations::Report tps::operations::evaluate_in<tps::Mp100>(const Operation&, const Input&,
                                                                          std::string_view, Detail);
