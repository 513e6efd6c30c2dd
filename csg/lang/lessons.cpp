// lessons.cpp — what an author whose words do not fit the grammar most likely meant, told by the words beside the one that does not fit.
//
// Each lesson is a habit of another language. They stand behind what the parser expected, never instead of it.
#include <algorithm>
#include <array>
#include <string_view>

#include "csg/lang/parser_state.h"

namespace whittle {
namespace {

struct Habit { std::string_view word, lesson; };

constexpr std::array kWordSigns = std::to_array<Habit>({{"and", "'and' is written &&"}, {"or", "'or' is written ||"}, {"not", "'not' is written !"}, {"mod", "'mod' is written %"}});

constexpr std::string_view kOneValue = "a name has one value in its scope, which cannot be counted up or changed later";
constexpr std::string_view kNoWord = "no word stands before the name: name = value;";

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) { return std::find(words.begin(), words.end(), word) != words.end(); }

}  // namespace

std::string Parser::found() const {
    if (kind() == Tok::kIdentifier) return '\'' + names_.text(now().text) + '\'';
    return spelling(kind());
}

// The word `back` places before the current one, if it is a name; else nothing.
std::string_view Parser::name_before(std::size_t back) const {
    if (position_ < back || tokens_[position_ - back].kind != Tok::kIdentifier) return {};
    return names_.text(tokens_[position_ - back].text);
}

Tok Parser::kind_before(std::size_t back) const { return position_ < back ? Tok::kEnd : tokens_[position_ - back].kind; }

std::string Parser::lesson() const {
    for (const std::size_t back : {std::size_t{0}, std::size_t{1}})
        for (const Habit& habit : kWordSigns)
            if (name_before(back) == habit.word) return std::string(habit.lesson);
    const Tok before = kind_before(1);
    const bool counts = before == Tok::kPlus || before == Tok::kMinus || before == Tok::kStar || before == Tok::kSlash;
    if (kind() == Tok::kAssign && before != Tok::kFunction && before != Tok::kModule) return std::string(counts ? kOneValue : "'==' compares; a value is given by name = value;");
    if ((kind() == Tok::kPlus || kind() == Tok::kMinus) && next_kind() == kind()) return std::string(kOneValue);
    if ((before == Tok::kPlus || before == Tok::kMinus) && kind_before(2) == before) return std::string(kOneValue);
    if ((kind() == Tok::kPlus || kind() == Tok::kMinus || kind() == Tok::kStar || kind() == Tok::kSlash) && next_kind() == Tok::kAssign) return std::string(kOneValue);
    if (kind() == Tok::kEqual || (kind() == Tok::kColon && before == Tok::kIdentifier)) return "a value is given with '=': name = value;";
    if (kind() == Tok::kOpenBracket && before == Tok::kIdentifier) return std::string(kOneValue);
    if (is_one_of(name_before(1), {"use", "include"})) return "files stand between < and >: use <file.scad>";
    if ((kind() == Tok::kCloseBrace || kind() == Tok::kEnd) && before == Tok::kCloseParen) return "is a ';' missing behind the ')'?";
    if (name_before(1) == "return") return "there is no return: function name(x) = value;";
    if (kind() == Tok::kIdentifier && is_one_of(name_before(1), {"def", "func", "fn", "void", "class", "sub", "procedure"}))
        return "function name(x) = value; makes values, module name(x) { } makes bodies";
    if (kind() == Tok::kIdentifier && next_kind() == Tok::kAssign && (before == Tok::kLet || is_one_of(name_before(1), {"var", "const", "int", "float", "double", "string", "bool", "local", "set"})))
        return std::string(kNoWord);
    if (kind() == Tok::kElse) return "an 'else' stands right behind the one statement or block of its 'if'";
    if (kind() == Tok::kOpenBrace && before == Tok::kAssign) return "a list is written in brackets: [1, 2]";
    return {};
}

}  // namespace whittle
