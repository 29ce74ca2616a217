// The SVG document: root, names for readers who do not see it, and a style sheet that reaches no other chart
// of a page.
#include <algorithm>
#include <array>
#include <cstdint>

#include "chart_parts.hpp"

namespace nutshell::chart::parts {
namespace {

struct Rule {
    const char *selector, *declarations;
};

// Each colour stands twice: plain for programs that know no variables (rsvg, PDF), then as a variable for
// light and dark.
constexpr std::array rules{
    Rule{"text", "font:16px Lato,'Segoe UI','Helvetica Neue',Arial,sans-serif;fill:#4a5159;fill:var(--mid)"},
    Rule{".title", "font-size:20px;font-weight:700;fill:#1d2126;fill:var(--ink)"},
    Rule{".tick,#.note,#.reason", "font-size:15px"},
    Rule{".paper", "fill:#fff;fill:var(--paper)"},
    Rule{".grid", "stroke:#e3e6ea;stroke:var(--grid);stroke-width:1"},
    Rule{".axis", "stroke:#5c636b;stroke:var(--mid);stroke-width:1.2"},
    Rule{".level,#.floor",
         "fill:none;stroke:#1d2126;stroke:var(--ink);stroke-width:1.4;stroke-dasharray:2 3"},
    Rule{".floor", "stroke-width:2.4;stroke-dasharray:none"},
    Rule{".guide path", "fill:none;stroke:#5c636b;stroke:var(--mid);stroke-width:1"},
    Rule{".ring", "fill:none;stroke:#1d2126;stroke:var(--ink);stroke-width:2;pointer-events:all"},
    Rule{".lead", "stroke:#5c636b;stroke:var(--mid);stroke-width:1"},
    Rule{".note,#.halo",
         "paint-order:stroke;stroke:#fff;stroke:var(--paper);stroke-width:4px;stroke-linejoin:round"},
    Rule{".note,#.reason", "fill:#1d2126;fill:var(--ink)"},
    Rule{".curve,#.ghost,#.theory", "fill:none;stroke:currentColor;stroke-width:2.2;stroke-linejoin:round"},
    Rule{".thin", "stroke-width:1.4"},
    Rule{".ghost", "stroke-width:7;stroke-linecap:round;opacity:.2"},
    Rule{".theory", "stroke-width:1.3;stroke-dasharray:5 4"},
    Rule{".area", "fill:currentColor;fill-opacity:.14;fill-rule:evenodd;stroke:none"},
    Rule{".mark,#.arrow,#.bar", "fill:currentColor;stroke:#fff;stroke:var(--paper);stroke-width:1.2"},
    Rule{".hollow", "fill:#fff;fill:var(--paper);stroke:currentColor;stroke-width:1.8"},
    Rule{".hair", "stroke:currentColor;stroke-width:1;opacity:.55"},
    Rule{".label", "font-weight:700;fill:currentColor"},
    Rule{".panel", "font-weight:700;fill:#1d2126;fill:var(--ink)"},
    Rule{".sup", "font-size:12px"},
    Rule{".narrow .sup", "font-size:14.6px"},
    Rule{".stem", "fill:none;stroke:currentColor;stroke-width:1.6;opacity:.45"},
    Rule{".least", "font-weight:700"},
    Rule{".body",
         "fill:#1d2126;fill:var(--ink);fill-opacity:.13;stroke:#1d2126;stroke:var(--ink);stroke-width:1.8"},
    Rule{".was", "fill-opacity:.04;stroke-dasharray:4 4;stroke-width:1.3"},
    Rule{".spring,#.rope,#.rod",
         "fill:none;stroke:#4a5159;stroke:var(--mid);stroke-width:2;stroke-linejoin:round"},
    Rule{".rope", "stroke-width:2.6"},
    Rule{".rod", "stroke-width:3.4;stroke-linecap:round"},
    Rule{".hatch,#.measure,#.way,#.dashed", "fill:none;stroke:#4a5159;stroke:var(--mid);stroke-width:1.1"},
    Rule{".way", "stroke-dasharray:1.5 4;stroke-width:1.8;stroke-linecap:round"},
    Rule{".dashed", "stroke-dasharray:6 4"},
    Rule{".shaft", "fill:none;stroke:currentColor;stroke-width:3.4"},
    Rule{".fine", "stroke-width:1.6"},
    Rule{".head", "fill:currentColor;stroke:none"},
    Rule{".disc,#.touch", "fill:#fff;fill:var(--paper);stroke:#1d2126;stroke:var(--ink);stroke-width:1.6"},
    Rule{".quarters", "fill:#1d2126;fill:var(--ink);stroke:none"},
    Rule{".measured", "fill:#1d2126;fill:var(--ink)"},
    Rule{".quiet .curve", "stroke:#8b929a;stroke-width:1.1;stroke-dasharray:none;opacity:.75"},
    Rule{".all:hover .series,#.all:has(.series:focus) .series", "opacity:.2"},
    Rule{".all:hover .series:hover,#.all .series:focus", "opacity:1"},
    Rule{".series:focus", "outline:none"},
    Rule{".series:focus-visible .label", "text-decoration:underline"},
};

/// The rule with `#id ` before each of its selectors ("#" in the table stands for a further one).
std::string scoped(const Rule& rule, const std::string& id) {
    std::string selector = "#" + id + " ";
    for (const char* c = rule.selector; *c; ++c)
        if (*c == '#')
            selector += "#" + id + " ";
        else
            selector += *c;
    return selector + "{" + rule.declarations + "}\n";
}

/// A name for the SVG and its style sheet: letters of the chart's name, and a hash of all it shows (FNV-1a).
std::string id_of(const std::string& name, const std::string& body) {
    std::string id = "chart-";
    for (const char c : name.substr(0, 40)) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (letter)
            id += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        else if (id.back() != '-')
            id += '-';
    }
    if (id.back() != '-') id += '-';
    std::uint32_t hash = 2166136261U;
    for (const char c : body) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    for (int k = 0; k < 6; ++k, hash >>= 4) id += "0123456789abcdef"[hash & 15U];
    return id;
}

/// A layout without its tooltips: a phone shows none.
std::string without_titles(const std::string& body) {
    std::string out;
    for (std::size_t at = 0;;) {
        const std::size_t open = body.find("<title>", at);
        out += body.substr(at, open == std::string::npos ? open : open - at);
        if (open == std::string::npos) return out;
        at = body.find("</title>", open) + 8;
    }
}

/// How wide a layout is drawn at most, on a wide screen [px]: a unit is 1.15 px, as far as the page is wide.
double widest_shown(double width) {
    return std::min(1.15 * width, std::max(928.0, width));
}

}  // namespace

std::string document(const std::string& name, const std::string& title, const std::string& told,
                     const Layout& wide, const Layout& narrow) {
    const std::string id = id_of(name, wide.body + told);
    const std::string w = unit(wide.width), h = unit(wide.height);
    const std::string own =
        ":where(#" + id + ")";  // weighs nothing: a page may set colours by .chart{--paper:...}
    std::string css =
        own + "{--ink:#1d2126;--mid:#4a5159;--grid:#e3e6ea;--paper:#fff;width:100%;height:auto;max-width:" +
        unit(widest_shown(wide.width)) + "px}\n";
    for (const Rule& rule : rules) css += scoped(rule, id);
    css += "@media screen and (prefers-color-scheme:dark){" + own +
           "{--ink:#eceff3;--mid:#b4bbc4;--grid:#2e343b;--paper:#15181c}\n#" + id + " .series,#" + id +
           " .levels{color:var(--d)}}\n";
    // The narrow layout where the page, or the column it gives to its figures, has no room for the wide one.
    const std::string room = unit(0.76 * wide.width) + "px";
    const std::string narrow_rules = "#" + id + "{aspect-ratio:" + unit(narrow.width) + "/" +
                                     unit(narrow.height) + ";max-width:" + unit(1.15 * narrow.width) +
                                     "px}#" + id + " .wide{display:none}#" + id + " .narrow{display:inline}";
    css += "#" + id + " .narrow{display:none}\n@media screen and (max-width:" + room + "){" + narrow_rules +
           "}\n@media screen{@container (max-width:" + room + "){" + narrow_rules + "}}\n";
    return "<svg xmlns='http://www.w3.org/2000/svg' class='chart' id='" + id + "' viewBox='0 0 " + w + ' ' +
           h + "' width='" + w + "' height='" + h +
           "' preserveAspectRatio='xMinYMin meet' role='group' aria-labelledby='" + id +
           "-t' aria-describedby='" + id + "-d'>\n<title id='" + id + "-t'>" + escaped(title) +
           "</title>\n<desc id='" + id + "-d'>" + escaped(told) + "</desc>\n<style>\n" + css +
           "</style>\n<g class='wide'>\n<rect class='paper' width='" + w + "' height='" + h + "'/>\n" +
           wide.body + "</g>\n<g class='narrow' transform='scale(" + spoken(wide.width / narrow.width) +
           ")'>\n<rect class='paper' width='" + unit(narrow.width) + "' height='" + unit(narrow.height) +
           "'/>\n" + without_titles(narrow.body) + "</g>\n</svg>\n";
}

}  // namespace nutshell::chart::parts
