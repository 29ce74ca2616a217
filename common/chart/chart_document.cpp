// The SVG document: root, names for readers who do not see it, and a style sheet that reaches no other chart
// of a page.
#include <array>

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
    Rule{".all:hover .series", "opacity:.2"},
    Rule{".all:hover .series:hover", "opacity:1"},
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

}  // namespace

std::string document(const Chart& chart, const std::string& id, double width, double height,
                     const std::string& body, const std::string& told) {
    const std::string w = unit(width), h = unit(height);
    // :where() weighs nothing: a page may set the four colours of its charts with .chart{--paper:...}
    std::string css =
        ":where(#" + id +
        "){--ink:#1d2126;--mid:#4a5159;--grid:#e3e6ea;--paper:#fff;max-width:100%;height:auto}\n";
    for (const Rule& rule : rules) css += scoped(rule, id);
    css += "@media screen and (prefers-color-scheme:dark){:where(#" + id +
           "){--ink:#eceff3;--mid:#b4bbc4;--grid:#2e343b;--paper:#15181c}\n#" + id +
           " .series{color:var(--d)}}\n";
    return "<svg xmlns='http://www.w3.org/2000/svg' class='chart' id='" + id + "' viewBox='0 0 " + w + ' ' +
           h + "' width='" + w + "' height='" + h + "' role='img' aria-labelledby='" + id + "-t " + id +
           "-d'>\n<title id='" + id + "-t'>" + escaped(chart.title) + "</title>\n<desc id='" + id + "-d'>" +
           escaped(told) + "</desc>\n<style>\n" + css + "</style>\n<rect class='paper' width='" + w +
           "' height='" + h + "'/>\n" + body + "</svg>\n";
}

}  // namespace nutshell::chart::parts
