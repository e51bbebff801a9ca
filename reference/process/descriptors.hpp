// Standard input, output and error, as the caller left them.
#pragma once

namespace tps {

/// Puts something in the place of those that are closed, so that no file is opened there. What takes the
/// place of standard input cannot be read, and that of standard output cannot be written: using them is an
/// error like any other. Standard error goes nowhere. To be called before anything else.
void occupy_standard_descriptors();

}  // namespace tps
