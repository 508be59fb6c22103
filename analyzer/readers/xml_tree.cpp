#include "analyzer/readers/xml_tree.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include <expat.h>
#include <fmt/format.h>

#include "common/error.hpp"

namespace recoat {
namespace {

struct FreeParser {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

/// Builds the tree out of the parser's calls.
struct Builder {
    XML_Parser parser;
    std::string_view last;
    XmlDocument document;
    std::vector<XmlElement*> open;
    bool stopped = false, too_deep = false;
    std::size_t stopped_at = 0;  ///< first byte of the opening tag of `last`
};

constexpr std::size_t deepest = 100;

std::map<std::string, std::string> attributes_of(const char** pairs) {
    std::map<std::string, std::string> attributes;
    for (; *pairs != nullptr; pairs += 2) attributes[pairs[0]] = pairs[1];
    return attributes;
}

void on_start(void* data, const char* name, const char** pairs) {
    auto& builder = *static_cast<Builder*>(data);
    if (builder.stopped) return;
    builder.too_deep = builder.open.size() >= deepest;
    if (name == builder.last || builder.too_deep) {
        builder.document.last_attributes = attributes_of(pairs);
        builder.stopped = true;
        builder.stopped_at = static_cast<std::size_t>(XML_GetCurrentByteIndex(builder.parser));
        XML_StopParser(builder.parser, XML_FALSE);
        return;
    }
    XmlElement& element = builder.open.empty() ? builder.document.root : builder.open.back()->children.emplace_back();
    element.name = name;
    element.attributes = attributes_of(pairs);
    element.line = XML_GetCurrentLineNumber(builder.parser);
    builder.open.push_back(&element);
}

void on_end(void* data, const char*) {
    auto& builder = *static_cast<Builder*>(data);
    if (!builder.stopped && !builder.open.empty()) builder.open.pop_back();
}

void on_text(void* data, const char* text, int size) {
    auto& builder = *static_cast<Builder*>(data);
    if (builder.stopped || builder.open.empty()) return;
    XmlElement& element = *builder.open.back();
    if (element.text.empty()) element.text_line = XML_GetCurrentLineNumber(builder.parser);
    element.text.append(text, static_cast<std::size_t>(size));
}

/// Hands the text over in pieces: the parser counts in int.
bool parse_all(XML_Parser parser, std::string_view text, const Builder& builder) {
    constexpr std::size_t piece_size = 1U << 24;
    for (std::size_t start = 0; start <= text.size(); start += piece_size) {
        const std::string_view piece = text.substr(start, piece_size);
        const bool is_last = start + piece.size() == text.size();
        const auto status = XML_Parse(parser, piece.data(), static_cast<int>(piece.size()), is_last ? 1 : 0);
        if (builder.stopped) return !builder.too_deep;
        if (status != XML_STATUS_OK) return false;
        if (is_last) return true;
    }
    return true;
}

}  // namespace

const XmlElement* XmlElement::child(std::string_view wanted) const {
    const auto found = std::ranges::find(children, wanted, &XmlElement::name);
    return found == children.end() ? nullptr : &*found;
}

std::string XmlElement::attribute(const std::string& wanted, const std::string& fallback) const {
    const auto found = attributes.find(wanted);
    return found == attributes.end() ? fallback : found->second;
}

XmlDocument parse_xml(std::string_view text, const std::string& file, std::string_view last) {
    const std::unique_ptr<XML_ParserStruct, FreeParser> parser(XML_ParserCreate(nullptr));
    Builder builder{.parser = parser.get(), .last = last, .document = {}, .open = {}};
    XML_SetUserData(parser.get(), &builder);
    XML_SetElementHandler(parser.get(), on_start, on_end);
    XML_SetCharacterDataHandler(parser.get(), on_text);
    if (!parse_all(parser.get(), text, builder)) {
        throw InputError(
            fmt::format("{}:{}: column {}: the file is no whole XML file ({}); copy it again from where it was made",
                        file, XML_GetCurrentLineNumber(parser.get()), XML_GetCurrentColumnNumber(parser.get()) + 1,
                        builder.too_deep ? "elements too deep" : XML_ErrorString(XML_GetErrorCode(parser.get()))));
    }
    if (builder.stopped) {
        const std::size_t end = std::min(text.find('>', builder.stopped_at), text.size() - 1);
        builder.document.rest = text.substr(end + 1);
    }
    return std::move(builder.document);
}

}  // namespace recoat
