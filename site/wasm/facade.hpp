// What a page asks of the reference: text in, text out.
#pragma once

#include <string>
#include <string_view>

namespace tps::web {

/// Answers a request, {"do":WORD,…}, as JSON; an error is {"error":MESSAGE}.
///
/// `operations`: {} → what can be evaluated: names, equations, keys.
/// `eval`: {"op","in","scalar"} → {"steps":[…],"results":[…]} of Quantity, each {key, symbol, formula,
///   decimal, hex, word}, as `tps eval` prints them. Scalars: float, double, mp50.
/// `certified`: {"op","in"} of block_time, tether_time → {"verdict","t"}; of order → {"order"}: the exact
///   answers of verify/exact.
/// `known_answer`: {"op","in"} of an equation with known answers → {"header","case"}: the two lines of a file
///   that `tps vectors verify` reads, with the proof or the enclosures.
/// `flight`: {"in"} of distance → {"A","B"}: where they are after dt.
/// `scene`: {"name","options":{…}} → {"scene":{…}}, as `tps scene` writes it.
/// `run`: {"scene","timing","until","max_events"} → {"trace":LINES,"end","events"}, as `tps run --scalar
///   double` does.
std::string answer(std::string_view request);

}  // namespace tps::web
