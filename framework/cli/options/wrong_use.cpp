#include "cli/options/wrong_use.hpp"

#include "common/phrases.hpp"
#include "common/spelling.hpp"

#include <algorithm>
#include <vector>

namespace opal::cli {
namespace {

const CLI::App& command_in(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  return *command;
}

std::string full_name(const CLI::App& command) {
  return command.get_parent() ? full_name(*command.get_parent()) + ' ' + command.get_name() : command.get_name();
}

/// "--quieries=x" is of the option "--quieries".
std::string option_word(const std::string& word) { return word.substr(0, word.find('=')); }

std::string option_meant_by(const CLI::App& command, const std::string& word) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames())
      if (is_misspelt(word, "--" + name)) return ", did you mean --" + name + "?";
  return "";
}

/// Of words that the command does not take. Behind an option that is unknown stands its value: only the option is told.
std::string unknown_words(const CLI::App& command) {
  std::vector<std::string> options, others;
  for (const std::string& word : command.remaining())
    (word.starts_with("-") ? options : others).push_back(option_word(word));
  if (options.empty()) return "not expected: " + listed(others);
  const std::string& first = options.front();
  return first + ": no option of this command" + option_meant_by(command, first);
}

std::string usage_of(const CLI::App& command) {
  std::string usage = CLI::Formatter().make_usage(&command, full_name(command));
  while (usage.starts_with('\n')) usage.erase(0, 1);
  while (usage.ends_with('\n')) usage.pop_back();
  return usage;
}

}  // namespace

std::string wrong_use(const CLI::App& app, const CLI::Error& error) {
  const CLI::App& command = command_in(app);
  const bool is_unknown = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  const std::string what = is_unknown ? unknown_words(command) : std::string(error.what());
  return full_name(command) + ": " + what + '\n' + usage_of(command) + "\n'" + full_name(command) +
         " --help' explains every option\n";
}

}  // namespace opal::cli
