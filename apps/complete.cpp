// SPDX-License-Identifier: MIT
// What may be typed where the cursor is. Asked by the shells (completion.cpp), at every press of
// their key, so that they know what this very program takes.
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "commands.h"
#include "penumbra/scene/gallery.h"
#include "usage_error.h"

namespace penumbra {
namespace {

struct Candidate {
  std::string word, help;
};

struct Candidates {
  std::vector<Candidate> words;
  bool has_files = false;  ///< names of files, too
};

bool is_hidden(const CLI::App& command) { return command.get_group().empty(); }

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// What the option's own parser says that it takes, when it is given what nothing takes.
std::vector<std::string> choices_of(CLI::Option& option) {
  try {
    option.add_result("?")->run_callback();
  } catch (const UsageError& error) {
    return error.choices;
  } catch (const CLI::Error&) {  // takes another number of words
  }
  return {};
}

std::vector<Candidate> built_in_scenes() {
  std::vector<Candidate> scenes;
  for (const GalleryEntry& entry : gallery_help())
    scenes.push_back({entry.name.substr(0, entry.name.find(':')), entry.description});
  return scenes;
}

/// Values of an option or argument. Of a list, the last part is completed.
Candidates values_of(CLI::Option& option, const std::string& typed) {
  Candidates values;
  const bool is_list = option.get_type_name() == "LIST";
  const std::string before = is_list ? typed.substr(0, typed.rfind(',') + 1) : "";
  for (const std::string& choice : choices_of(option))
    values.words.push_back({before + choice, {}});
  if (option.nonpositional()) {
    const std::string type = option.get_type_name();
    values.has_files = type.find("FILE") != type.npos || type.find("DIR") != type.npos;
  } else if (values.words.empty()) {
    const std::string name = option.get_name(true);
    if (name == "SCENE" || name == "NAME") values.words = built_in_scenes();
    values.has_files = name != "NAME";
  }
  return values;
}

Candidates options_of(CLI::App& command) {
  Candidates options;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames())
      options.words.push_back({"--" + name, option->get_description()});
  return options;
}

/// The argument that comes after so many.
CLI::Option* argument_after(CLI::App& command, std::size_t count) {
  std::vector<CLI::Option*> arguments =
      command.get_options([](const CLI::Option* option) { return !option->nonpositional(); });
  if (arguments.empty()) return nullptr;
  return arguments[std::min(count, arguments.size() - 1)];
}

/// `words`: what follows the command; the last is being typed.
Candidates candidates_in(CLI::App& command, std::span<const std::string> words) {
  const std::string& typed = words.back();
  CLI::Option* waiting = nullptr;  // option whose value is next
  std::size_t arguments = 0;
  for (const std::string& word : words.first(words.size() - 1)) {
    if (word.starts_with('-')) {
      waiting = command.get_option_no_throw(word);
      if (waiting && !takes_value(*waiting)) waiting = nullptr;
    } else {
      arguments += !waiting;
      waiting = nullptr;
    }
  }
  if (waiting) return values_of(*waiting, typed);
  if (const std::size_t equals = typed.find('='); typed.starts_with("--") && equals != typed.npos) {
    CLI::Option* option = command.get_option_no_throw(typed.substr(0, equals));
    if (!option || !takes_value(*option)) return {};
    Candidates values = values_of(*option, typed.substr(equals + 1));
    for (Candidate& value : values.words) value.word.insert(0, typed.substr(0, equals + 1));
    return values;
  }
  if (typed.starts_with('-')) return options_of(command);
  CLI::Option* argument = argument_after(command, arguments);
  return argument ? values_of(*argument, typed) : options_of(command);
}

Candidates all_candidates(CLI::App& program, std::span<const std::string> words) {
  if (words.size() > 1) {
    for (CLI::App* command : program.get_subcommands({}))
      if (command->get_name() == words.front()) return candidates_in(*command, words.subspan(1));
    return {};
  }
  Candidates candidates = options_of(program);
  for (const CLI::App* command : program.get_subcommands({}))
    if (!is_hidden(*command))
      candidates.words.push_back({command->get_name(), command->get_description()});
  return candidates;
}

int run(CLI::App& program, const std::vector<std::string>& words) {
  const Candidates candidates = all_candidates(program, words);
  for (const Candidate& candidate : candidates.words)
    if (candidate.word.starts_with(words.back()))
      fmt::print("{}\t{}\n", candidate.word, candidate.help);
  if (candidates.has_files) fmt::print(":files\n");
  return 0;
}

}  // namespace

Command add_complete(CLI::App& program) {
  CLI::App* app = program.add_subcommand("complete", "Say what may be typed next, for shells");
  const auto words = std::make_shared<std::vector<std::string>>();
  app->add_option("WORDS", *words, "The command line after the program, to the cursor");
  app->group("");
  app->footer("Example:\n  penumbra complete -- render --method s\n");
  return {app, [&program, words] {
            if (words->empty()) words->emplace_back();
            return run(program, *words);
          }};
}

}  // namespace penumbra
