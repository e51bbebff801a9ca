// The reference as an implementation of the protocol, over a pair of descriptors.
#pragma once

#include <functional>

#include "reference/text/output.hpp"

namespace tps::protocol {

enum class ServeEnd {
  finished,     ///< "bye", or no more lines
  interrupted,  ///< `stop` said so
};

/// Answers requests, one a line, until there are no more. Replies are written whenever no further request
/// waits.
///
/// `stop` is asked whenever a signal arrives while waiting. Throws InputError where the input cannot be read,
/// OutputError where nobody takes the replies.
ServeEnd serve(int input, Output& output, const std::function<bool()>& stop);

}  // namespace tps::protocol
