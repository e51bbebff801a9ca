// Files of known answers, as `tps vectors` reads them: proven again, judged by, turned into requests.
#pragma once

#include <string>
#include <vector>

namespace tps::cli {

/// Proves every case again; prints what is wrong and how many; the exit code. "-" is the standard input.
int verify_cases(const std::vector<std::string>& files);

/// Judges the replies in the file `answers` by the cases; the exit code.
int verify_answers(const std::vector<std::string>& files, const std::string& answers);

/// Writes the cases as requests of the protocol on standard output.
void write_requests(const std::vector<std::string>& files);

}  // namespace tps::cli
