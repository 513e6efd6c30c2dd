// test_documents.cpp — man page and completions name every option that the program takes, and no option is promised that it refuses.
#include <algorithm>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "modeler/cli/parse.h"
#include "run_program.h"

using namespace whittle;

namespace {

std::string read(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(std::string(WHITTLE_SOURCE_DIR) + "/share/" + name).rdbuf();
    return text.str();
}

std::string without_backslashes(std::string text) {
    text.erase(std::remove(text.begin(), text.end(), '\\'), text.end());
    return text;
}

// `word` with no letter or dash right before or after.
bool has_word(const std::string& text, const std::string& word) {
    const auto inside = [&](std::size_t i) { return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '-'); };
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        if (!(at > 0 && inside(at - 1)) && !inside(at + word.size())) return true;
    return false;
}

bool refused(const std::string& verb, const std::string& option) {
    std::vector<std::string> words{"a.scad", option, "1"};
    if (!verb.empty()) words.insert(words.begin(), verb);
    const auto parsed = parse_command_line(words);
    if (!parsed && parsed.error().message == option + " is not supported yet") return true;
    words.pop_back();
    const auto flag = parse_command_line(words);
    return !flag && flag.error().message == option + " is not supported yet";
}

}  // namespace

TEST_CASE("the man page names every option and every verb") {
    const std::string page = without_backslashes(read("man/whittle.1"));
    auto verbs = verb_names();
    for (const auto& verb : verbs) CHECK(has_word(page, verb));
    verbs.emplace_back("");
    for (const auto& verb : verbs) {
        if (verb == "bench") continue;
        for (const auto& option : option_names(verb)) {
            INFO(option);
            CHECK(has_word(page, option));
        }
    }
}

TEST_CASE("completions offer what the program takes and not what it refuses") {
    const std::string bash = read("completions/whittle.bash"), zsh = read("completions/_whittle"), fish = read("completions/whittle.fish");
    auto verbs = verb_names();
    for (const auto& verb : verbs)
        for (const auto* text : {&bash, &zsh, &fish}) CHECK(has_word(*text, verb));
    verbs.emplace_back("");
    for (const auto& verb : verbs) {
        if (verb == "bench") continue;
        for (const auto& option : option_names(verb)) {
            const bool offered = !refused(verb, option);
            const std::string in_fish = option.rfind("--", 0) == 0 ? "-l " + option.substr(2) : "-s " + option.substr(1);
            INFO(verb << " " << option);
            CHECK(has_word(bash, option) == offered);
            CHECK(has_word(zsh, option) == offered);
            CHECK(has_word(fish, in_fish) == offered);
        }
    }
}
