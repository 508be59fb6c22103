#pragma once

#include <deque>
#include <map>
#include <string>
#include <string_view>

namespace recoat {

/// An element of an XML file.
struct XmlElement {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;  ///< all character data directly in it
    std::deque<XmlElement> children;
    std::size_t line = 0;       ///< of its opening tag
    std::size_t text_line = 0;  ///< of the first character of the text

    /// First child of this name, or null.
    [[nodiscard]] const XmlElement* child(std::string_view wanted) const;
    /// Value of an attribute, or `fallback`.
    [[nodiscard]] std::string attribute(const std::string& wanted, const std::string& fallback = {}) const;
};

/// An XML document up to the element named `last`, from which the rest need not be XML.
struct XmlDocument {
    XmlElement root;
    std::map<std::string, std::string> last_attributes;
    std::string_view rest;  ///< what follows the opening tag of `last`; empty when there is none
};

/// Parses `text`, which must outlive the result. Throws InputError with `file` and the line when it is no XML.
[[nodiscard]] XmlDocument parse_xml(std::string_view text, const std::string& file, std::string_view last);

}  // namespace recoat
