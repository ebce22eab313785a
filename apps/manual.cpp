// SPDX-License-Identifier: MIT
// Manual pages, one a command, in the macros of man(7), from the same descriptions as --help.
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "commands.h"
#include "options.h"
#include "penumbra/scene_io/write_scene.h"
#include "penumbra/version.h"

namespace penumbra {
namespace {

struct Page {
  std::string name, summary;
  std::string body;
};

/// Text that roff prints as it stands; `code` in bold.
std::string plain(std::string_view text) {
  std::string roff;
  bool is_code = false;
  for (const char c : text) {
    if (c == '\\') {
      roff += "\\e";
    } else if (c == '-') {
      roff += "\\-";
    } else if (c == '`') {
      is_code = !is_code;
      roff += is_code ? "\\fB" : "\\fR";
    } else {
      roff += c;
    }
  }
  return roff;
}

/// A line of text, not to be taken for a request.
std::string line(std::string_view roff) {
  const bool is_like_request = roff.starts_with('.') || roff.starts_with('\'');
  return fmt::format("{}{}\n", is_like_request ? "\\&" : "", roff);
}

/// Running text, in lines of a length that people can read.
std::string running(std::string_view text) {
  constexpr std::size_t longest = 76;
  const std::string roff = plain(text);
  std::string_view rest = roff;
  std::string lines;
  while (rest.size() > longest && rest.rfind(' ', longest) != rest.npos) {
    const std::size_t space = rest.rfind(' ', longest);
    lines += line(rest.substr(0, space));
    rest.remove_prefix(space + 1);
  }
  return lines + line(rest);
}

std::string bold(std::string_view text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + plain(text) + "\\fR"; }

std::string section(std::string_view title) { return fmt::format(".SH {}\n", title); }

/// A term, and what is said of it.
std::string item(const std::string& term, std::string_view text) {
  return fmt::format(".TP\n{}\n{}", term, text.empty() ? "" : running(text));
}

bool is_visible(const CLI::App* command) { return !command->get_group().empty(); }

std::string option_term(const CLI::Option& option) {
  std::string term;
  const auto add = [&term](const std::string& name) {
    term += (term.empty() ? "" : ", ") + bold(name);
  };
  for (const std::string& name : option.get_snames()) add("-" + name);
  for (const std::string& name : option.get_lnames()) add("--" + name);
  if (option.get_items_expected_max() == 0) return term;
  return term + ' ' + italic(option.get_type_name()) +
         (option.get_items_expected_max() > 1 ? " ..." : "");
}

std::string argument_term(const CLI::Option& argument) {
  const std::string name =
      italic(argument.get_name(true)) + (argument.get_items_expected_max() > 1 ? "..." : "");
  return argument.get_required() ? name : "[" + name + "]";
}

std::vector<const CLI::Option*> arguments_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return !option->nonpositional(); });
}

std::string options_text(const CLI::App& command) {
  std::string text;
  for (const std::string& group : command.get_groups()) {
    std::string items;
    for (const CLI::Option* option : command.get_options())
      if (option->nonpositional() && option->get_group() == group)
        items += item(option_term(*option), option->get_description());
    if (items.empty()) continue;
    text += group == "Options" ? section("OPTIONS") : fmt::format(".SS {}\n", group);
    text += items;
  }
  return text;
}

/// What stands below the options in the help: paragraphs; indented lines, which are items with or
/// without an explanation; examples; exit codes.
struct Footer {
  std::string notes, examples, exit_codes;
};

std::string indented_line(std::string_view text) {
  text.remove_prefix(text.find_first_not_of(' '));
  const std::size_t gap = text.find("  ");
  if (gap == text.npos) return item(plain(text), {});
  return item(plain(text.substr(0, gap)), text.substr(text.find_first_not_of(' ', gap)));
}

Footer footer_of(const CLI::App& command) {
  constexpr std::string_view exit_code = "Exit code: ";
  Footer footer;
  std::istringstream lines(command.get_footer());
  bool are_examples = false, is_new = true;
  for (std::string text; std::getline(lines, text);) {
    if (text.empty()) {
      is_new = true;
    } else if (text.starts_with("Example")) {
      are_examples = true;
    } else if (text.starts_with(exit_code)) {
      footer.exit_codes = running(text.substr(exit_code.size()));
      is_new = true;
    } else if (text.starts_with(' ') && are_examples) {
      footer.examples += line(plain(text.substr(text.find_first_not_of(' '))));
    } else if (text.starts_with(' ')) {
      footer.notes += indented_line(text);
      is_new = true;
    } else {
      are_examples = false;
      footer.notes += (is_new && !footer.notes.empty() ? ".PP\n" : "") + running(text);
      is_new = false;
    }
  }
  return footer;
}

/// What all pages end with.
std::string end_of(const CLI::App& command, const std::vector<std::string>& see_also) {
  const Footer footer = footer_of(command);
  std::string text;
  if (!footer.notes.empty()) text += section("NOTES") + footer.notes;
  text += section("EXIT STATUS");
  text += footer.exit_codes.empty()
              ? item("0", "Done.") +
                    item("1", "The input is wrong, or the output cannot be written.") +
                    item("2", "The command line is wrong.")
              : footer.exit_codes;
  if (!footer.examples.empty()) text += section("EXAMPLES") + ".nf\n" + footer.examples + ".fi\n";
  text += section("SEE ALSO");
  for (const std::string& page : see_also)
    text += fmt::format(".BR \\%{} (1){}\n", plain(page), page == see_also.back() ? "" : ",");
  return text;
}

std::string page_name(const CLI::App& command) { return "penumbra-" + command.get_name(); }

Page command_page(const CLI::App& command) {
  Page page{page_name(command), command.get_description(), {}};
  page.body =
      section("SYNOPSIS") + bold("penumbra " + command.get_name()) + " [" + italic("OPTIONS") + "]";
  std::string items;
  for (const CLI::Option* argument : arguments_of(command)) {
    page.body += ' ' + argument_term(*argument);
    items += item(italic(argument->get_name(true)), argument->get_description());
  }
  page.body += '\n' + section("DESCRIPTION") + running(command.get_description() + ".");
  if (!items.empty()) page.body += section("ARGUMENTS") + items;
  page.body += options_text(command) + end_of(command, {"penumbra"});
  return page;
}

Page program_page(const CLI::App& program, const std::vector<const CLI::App*>& commands) {
  Page page{"penumbra", "soft shadows at the price of hard ones", {}};
  page.body = section("SYNOPSIS") + bold("penumbra") + ' ' + italic("COMMAND") + " [" +
              italic("OPTIONS") + "]\n" + section("DESCRIPTION") +
              running(program.get_description()) + section("COMMANDS");
  std::vector<std::string> pages;
  for (const CLI::App* command : commands) {
    page.body += item(bold(command->get_name()), command->get_description() + ".");
    pages.push_back(page_name(*command));
  }
  page.body += options_text(program) + end_of(program, pages);
  return page;
}

void write_page(const std::filesystem::path& folder, const Page& page, const std::string& date) {
  std::string title = page.name, summary = page.summary;
  const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; };
  std::transform(title.begin(), title.end(), title.begin(), upper);
  if (summary[0] >= 'A' && summary[0] <= 'Z') summary[0] = static_cast<char>(summary[0] + 32);
  write_file(folder / (page.name + ".1"),
             fmt::format(".TH {} 1 \"{}\" \"penumbra {}\" \"User Commands\"\n"
                         ".SH NAME\n{} \\-\n{}{}",
                         plain(title), date, PENUMBRA_VERSION, plain(page.name), running(summary),
                         page.body));
}

struct Options {
  std::string folder, date;
};

int run(const CLI::App& program, const Options& options) {
  const std::vector<const CLI::App*> commands = program.get_subcommands(is_visible);
  write_page(options.folder, program_page(program, commands), options.date);
  for (const CLI::App* command : commands)
    write_page(options.folder, command_page(*command), options.date);
  return 0;
}

}  // namespace

Command add_manual(CLI::App& program) {
  CLI::App* app = program.add_subcommand("manual", "Write the manual pages");
  const auto options = std::make_shared<Options>();
  app->add_option("DIR", options->folder, "A folder that exists")->required();
  app->add_option("--date", options->date, "What the pages say when they were made")
      ->type_name("DATE");
  app->group("");
  app->footer("Example:\n  penumbra manual man1 --date 2026-11-22\n");
  return {app, [&program, options] { return run(program, *options); }};
}

}  // namespace penumbra
