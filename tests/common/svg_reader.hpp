// Reads an SVG as strictly as a browser reads XML, so that tests can ask where things stand.
#pragma once
#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

struct Element {
    std::string tag, css_class;
    std::string text;     ///< its own and its children's, entities resolved, without tooltips
    std::string tooltip;  ///< the text of its <title>
    std::map<std::string, std::string> attributes;
    std::size_t parent = 0;
    double number(const std::string& name) const { return std::stod(attributes.at(name)); }
};

/// All elements in the order of the document. @throws std::runtime_error where the text is no well-formed XML
inline std::vector<Element> read_svg(const std::string& svg) {
    const auto fail = [&](const std::string& why, std::size_t at) {
        throw std::runtime_error(why + " at: " + svg.substr(at, 60));
    };
    const auto plain = [&](const std::string& text, std::size_t at) {
        static const std::map<std::string, char> entities{
            {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"#39", '\''}};
        std::string result;
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (static_cast<unsigned char>(text[i]) < 32 && text[i] != '\n') fail("control character", at);
            if (text[i] != '&') {
                result += text[i];
                continue;
            }
            const std::size_t end = text.find(';', i);
            if (end == std::string::npos || !entities.count(text.substr(i + 1, end - i - 1)))
                fail("bare &", at);
            result += entities.at(text.substr(i + 1, end - i - 1));
            i = end;
        }
        return result;
    };
    std::vector<Element> elements;
    std::vector<std::size_t> open;
    std::map<std::string, int> ids;
    for (std::size_t at = 0; at < svg.size();) {
        if (svg[at] != '<') {
            const std::size_t end = std::min(svg.find('<', at), svg.size());
            const std::string text = plain(svg.substr(at, end - at), at);
            if (open.empty() && text.find_first_not_of(" \n") != std::string::npos)
                fail("text outside the root", at);
            for (const std::size_t e : open)
                if (elements[open.back()].tag != "title" || e == open.back()) elements[e].text += text;
            at = end;
            continue;
        }
        if (svg[at + 1] == '/') {
            const std::size_t end = svg.find('>', at);
            if (open.empty() || svg.substr(at + 2, end - at - 2) != elements[open.back()].tag)
                fail("wrong closing tag", at);
            if (const Element& done = elements[open.back()]; done.tag == "title")
                elements[done.parent].tooltip = done.text;
            open.pop_back();
            at = end + 1;
            continue;
        }
        if (open.empty() && !elements.empty()) fail("second root", at);
        Element element;
        std::size_t i = svg.find_first_of(" />", at + 1);
        element.tag = svg.substr(at + 1, i - at - 1);
        if (element.tag.empty()) fail("< that opens no tag", at);
        for (i = svg.find_first_not_of(' ', i); svg.at(i) != '>' && svg[i] != '/';
             i = svg.find_first_not_of(' ', i)) {
            const std::size_t equals = svg.find('=', i);
            const char quote = svg.at(equals + 1);
            if (quote != '\'' && quote != '"') fail("attribute without quotes", i);
            const std::size_t end = svg.find(quote, equals + 2);
            const std::string value = svg.substr(equals + 2, end - equals - 2);
            if (value.find('<') != std::string::npos) fail("< in an attribute", i);
            if (!element.attributes.emplace(svg.substr(i, equals - i), plain(value, i)).second)
                fail("attribute twice", i);
            i = end + 1;
        }
        element.parent = open.empty() ? 0 : open.back();
        element.css_class = element.attributes["class"];
        if (const std::string id = element.attributes["id"]; !id.empty() && ids[id]++) fail("id twice", at);
        elements.push_back(element);
        const bool closed = svg[i] == '/';
        if (!closed) open.push_back(elements.size() - 1);
        at = svg.find('>', i) + 1;
    }
    if (!open.empty()) throw std::runtime_error("<" + elements[open.back()].tag + "> is not closed");
    return elements;
}

inline std::vector<Element> of_class(const std::vector<Element>& elements, const std::string& css_class) {
    std::vector<Element> result;
    std::copy_if(elements.begin(), elements.end(), std::back_inserter(result), [&](const Element& e) {
        return (" " + e.css_class + " ").find(" " + css_class + " ") != std::string::npos;
    });
    return result;
}

/// A picture's layouts, each as a document of its own.
inline std::string wide_layout(const std::string& svg) {
    return svg.substr(0, svg.find("<g class='narrow'")) + "</svg>";
}
inline std::string narrow_layout(const std::string& svg) {
    const std::size_t wide = svg.find("<g class='wide'"), narrow = svg.find("<g class='narrow'");
    return svg.substr(0, wide) + svg.substr(narrow);
}
