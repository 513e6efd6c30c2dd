// token.h — the words of the language.
#pragma once

#include <cstdint>

#include "csg/lang/names.h"
#include "csg/lang/source.h"

namespace whittle {

enum class Tok : std::uint8_t {
    kEnd, kBad,  // kBad: a character or an unfinished string that no rule takes; Token::text is "what|hint"
    kNumber, kString, kIdentifier, kUse, kInclude,
    kModule, kFunction, kIf, kElse, kLet, kAssert, kEcho, kFor, kEach, kTrue, kFalse, kUndef,
    kSemicolon, kComma, kDot, kColon, kQuestion, kAssign,
    kOpenParen, kCloseParen, kOpenBracket, kCloseBracket, kOpenBrace, kCloseBrace,
    kOr, kAnd, kEqual, kNotEqual, kLess, kLessEqual, kGreater, kGreaterEqual,
    kPlus, kMinus, kStar, kSlash, kPercent, kCaret, kNot, kHash,
    kBitOr, kBitAnd, kShiftLeft, kShiftRight, kBitNot
};

struct Token {
    Tok kind = Tok::kEnd;
    SourcePlace place;
    std::uint32_t text = 0;  // NameId of an identifier or keyword; index into the strings of a string, path or complaint
    double number = 0;
};

// How the token is written, for messages ("')'", "a number").
const char* spelling(Tok kind);

}  // namespace whittle
