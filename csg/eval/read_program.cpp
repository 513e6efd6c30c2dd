#include "csg/eval/read_program.h"

#include <algorithm>
#include <filesystem>

#include "csg/eval/large_stack.h"
#include "csg/lang/lexer.h"
#include "csg/lang/parser.h"

namespace whittle {
namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }
std::string joined(const std::string& folder, const std::string& path) { return folder.empty() ? path : (fs::path(folder) / path).lexically_normal().string(); }

// Whittle's own modules are built in: the file that defines them for OpenSCAD is read as an empty one.
bool is_own_library(const std::string& path) { return fs::path(path).filename() == "whittle.scad"; }

bool is_font(const std::string& path) {
    const std::string suffix = fs::path(path).extension().string();
    return suffix == ".ttf" || suffix == ".otf" || suffix == ".TTF" || suffix == ".OTF";
}

}  // namespace

std::string ProgramReader::name_of(const std::string& path) const {
    const std::string folder = folder_of(input_.path);
    if (folder.empty()) return path;
    const fs::path relative = fs::path(path).lexically_relative(folder);
    return relative.empty() ? path : relative.string();
}

// OpenSCAD's message names no place: the hint does, with the line itself, and where was looked.
void ProgramReader::warn_missing(const char* what, const std::string& asked, SourcePlace place, const std::string& why) {
    std::string hint = "asked for in file " + out_.sources.files[place.file].name + ", line " + std::to_string(place.line);
    if (!why.empty()) {
        hint += "; " + why;
    } else if (!fs::path(asked).is_absolute()) {
        hint += "; looked beside that file";
        for (const std::string& library : input_.library_paths) hint += ", in " + library;
    }
    // OpenSCAD's line names no place, so the caret comes with the hint.
    const std::string caret = format_caret({Severity::kWarning, place, {}, {}}, out_.sources);
    hint.insert(0, caret + '\n');
    out_.diagnostics.add(Severity::kWarning, {}, std::string("Can't open ") + what + " '" + asked + "'.", hint);
}

// Beside the file that asks, then in the library folders; empty when nowhere.
std::string ProgramReader::find(const std::string& path, const std::string& folder) const {
    if (fs::path(path).is_absolute()) return outside_.exists(path) ? path : std::string();
    if (const std::string beside = joined(folder, path); outside_.exists(beside)) return beside;
    for (const std::string& library : input_.library_paths)
        if (const std::string there = joined(library, path); outside_.exists(there)) return there;
    return {};
}

std::uint32_t ProgramReader::add_source(const std::string& path, std::string text) {
    out_.sources.files.push_back({path, name_of(path), std::move(text)});
    if (std::find(out_.files_read.begin(), out_.files_read.end(), path) == out_.files_read.end()) out_.files_read.push_back(path);
    return static_cast<std::uint32_t>(out_.sources.files.size() - 1);
}

std::vector<Token> ProgramReader::tokens_of(std::uint32_t source, StringPool& strings) {
    const std::string path = out_.sources.files[source].path;
    const std::string folder = folder_of(path);
    std::vector<Token> out;
    for (const Token& token : lex(out_.sources.files[source].text, source, program_.names, strings)) {
        if (token.kind == Tok::kInclude) {
            include(token, strings[token.text], folder, out, strings);
            continue;
        }
        if (token.kind == Tok::kUse) {
            const std::string& asked = strings[token.text];
            const std::string found = is_own_library(asked) ? asked : find(asked, folder);
            if (found.empty()) warn_missing("library", asked, token.place, {});
            else if (is_font(asked)) program_.fonts.push_back(found);
            else if (!is_own_library(asked)) wanted_.emplace_back(found, token.place);
        }
        out.push_back(token);
    }
    return out;
}

void ProgramReader::include(const Token& token, const std::string& path, const std::string& folder, std::vector<Token>& out, StringPool& strings) {
    if (is_own_library(path)) return;
    const std::string asked = path;
    const std::string found = find(asked, folder);
    if (found.empty() || open_.count(found)) {
        warn_missing("include file", asked, token.place, found.empty() ? "" : "it is being read already: files include each other");
        return;
    }
    Result<std::string> text = outside_.read_text(found);
    if (!text) {
        warn_missing("include file", asked, token.place, text.error().message);
        return;
    }
    if (open_.size() >= kMaxIncludeDepth || out_.sources.files.size() >= kMaxSources) {
        if (!too_many_) out_.diagnostics.add(Severity::kError, token.place, "Too many include files");
        too_many_ = true;
        return;
    }
    open_.insert(found);
    std::vector<Token> inner = tokens_of(add_source(found, std::move(*text)), strings);
    open_.erase(found);
    inner.pop_back();  // its end
    out.insert(out.end(), inner.begin(), inner.end());
}

// -D: assignments behind the main file, as text of a source of their own.
void ProgramReader::add_definitions(std::vector<Token>& tokens, StringPool& strings, std::uint32_t& file) {
    if (input_.definitions.empty()) return;
    std::string text;
    for (const std::string& definition : input_.definitions) text += definition + ";\n";
    out_.sources.files.push_back({"", "-D", std::move(text)});
    file = static_cast<std::uint32_t>(out_.sources.files.size() - 1);
    const std::vector<Token> more = lex(out_.sources.files[file].text, file, program_.names, strings);
    tokens.pop_back();
    tokens.insert(tokens.end(), more.begin(), more.end());
}

bool ProgramReader::parse_file(std::uint32_t index, std::vector<Token> tokens, StringPool strings, std::uint32_t source, std::uint32_t definitions) {
    ParseOptions options;
    options.deepest = kDeepestTree;
    options.sources = &out_.sources;
    options.main_file = source;
    options.definitions_file = definitions;
    FileSyntax& file = *program_.files[index];
    file.good = parse_tokens(tokens, std::move(strings), program_.names, options, out_.diagnostics, file.ast);
    return file.good;
}

bool ProgramReader::run(std::string main_text) {
    program_.files.push_back(std::make_unique<FileSyntax>());
    program_.files[0]->path = input_.path;
    const std::uint32_t source = add_source(input_.path, std::move(main_text));
    StringPool strings;
    std::vector<Token> tokens = tokens_of(source, strings);
    std::uint32_t definitions = ast::kNone;
    add_definitions(tokens, strings, definitions);
    const auto wanted = std::move(wanted_);
    if (!parse_file(0, std::move(tokens), std::move(strings), source, definitions) || too_many_) return false;
    used_[input_.path] = 0;
    for (const auto& [path, place] : wanted) {
        const std::uint32_t file = use(path);
        program_.files[0]->uses.push_back(file);
    }
    return true;
}

// Index of a used file, read when first met. Circles end at the file that is being read.
std::uint32_t ProgramReader::use(const std::string& path) {
    if (const auto it = used_.find(path); it != used_.end()) return it->second;
    const std::uint32_t index = static_cast<std::uint32_t>(program_.files.size());
    used_[path] = index;
    program_.files.push_back(std::make_unique<FileSyntax>());
    program_.files[index]->path = path;
    Result<std::string> text = outside_.read_text(path);
    if (!text) {
        out_.diagnostics.add(Severity::kWarning, {}, "Can't open library '" + path + "'.", text.error().message);
        text = std::string();
    }
    wanted_.clear();
    const std::set<std::string> open = std::exchange(open_, {path});
    const std::uint32_t source = add_source(path, std::move(*text));
    StringPool strings;
    std::vector<Token> tokens = tokens_of(source, strings);
    open_ = open;
    const auto wanted = std::exchange(wanted_, {});
    if (!parse_file(index, std::move(tokens), std::move(strings), source, ast::kNone)) {
        // A broken library gives nothing; its syntax errors have been said.
        program_.files[index]->ast = ast::Ast{};
        program_.files[index]->ast.scopes.emplace_back();
        program_.files[index]->ast.root = 0;
        return index;
    }
    for (const auto& [inner, place] : wanted) {
        const std::uint32_t file = use(inner);
        program_.files[index]->uses.push_back(file);
    }
    return index;
}

}  // namespace whittle
