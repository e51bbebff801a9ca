// Options that are made when their verb is called: those of all verbs took half of the time in which the
// program starts.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace tps::cli {

/// Has `make` add to a verb what only its own call and its own --help need, once its name is read from the
/// command line. Of several for one verb, in the order in which they were given.
void make_when_called(CLI::App* verb, std::function<void(CLI::App*)> make);

/// An empty value, as an unset variable of a script leaves one, is not the same as no option: it is refused
/// by all options that the program and its verbs have by now.
void refuse_empty_values(CLI::App& app);

}  // namespace tps::cli
