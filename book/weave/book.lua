-- book.lua: weaves all pages of the book in one run of pandoc (2.17 and newer). Called by build.sh.
-- Pass 1 reads the pages and numbers what can be referred to; pass 2 weaves and writes. What a page may say: HOWTO.md.
-- The parts: report.lua (complaints with line), regions.lua (code), numbers.lua, tables.lua, claims.lua, figures.lua, errata.lua, boxes.lua, page.lua.
PANDOC_VERSION:must_be_at_least("2.17", "book: pandoc %s or newer is needed, this is %s")
local env = function(name) return os.getenv("BOOK_" .. name) end
local here = env("HERE") .. "/weave/"
Book = {pages_dir = env("PAGES"), root = env("ROOT"), results = env("RESULTS"), live = env("LIVE"), out = env("OUT"), here = env("HERE"),
        prefix = env("PREFIX"), pages = {}, sources = {}, exercises = {}}
Report = dofile(here .. "report.lua")
Csv = dofile(here .. "csv.lua")
Regions = dofile(here .. "regions.lua")
Numbers = dofile(here .. "numbers.lua")
Tables = dofile(here .. "tables.lua")
Figures = dofile(here .. "figures.lua")
Errata = dofile(here .. "errata.lua")
Labels = dofile(here .. "labels.lua")
Boxes = dofile(here .. "boxes.lua")
Claims = dofile(here .. "claims.lua")
Page = dofile(here .. "page.lua")
Search = dofile(here .. "search.lua")

-- Images stay images: a picture alone in its paragraph is a figure, in every version of pandoc the same way.
-- "(8)" begins no list.
local markdown = "markdown-implicit_figures-latex_macros-fancy_lists-example_lists"

local function raw(html) return pandoc.RawInline("html", html) end
local function raw_block(html) return pandoc.RawBlock("html", html) end

--- Formulas are only marked here; katex.cjs sets them, and knows from data-at whom to blame.
--- A number in a formula is \num{NAME ...}.
function Book.math(page, m)
    local at = Report.line(page, m.text)
    local tex = m.text:gsub("\\num%s*(%b{})", function(spec) return Numbers.tex(page, spec:sub(2, -2), at) end)
    local display = m.mathtype == "DisplayMath" and " display" or ""
    return raw(('<span class="tex%s" data-at="%s%s:%d">%s</span>')
        :format(display, Book.prefix, page.file, at, Page.escape(tex)))
end

--- A short formula keeps the comma or full stop that follows it on its line: between the two a browser may break.
local function keep_together(list)
    for i = #list - 1, 1, -1 do
        local formula, after = list[i], list[i + 1]
        local tex = formula.t == "RawInline" and formula.text:match('^<span class="tex" [^>]*>(.*)</span>$')
        local mark, rest
        if tex and #tex <= 40 and after.t == "Str" then mark, rest = after.text:match("^([,.;:!?)]+)(.*)$") end
        if mark then
            list[i] = raw('<span class="together">' .. formula.text .. mark .. "</span>")
            if rest == "" then list:remove(i + 1) else after.text = rest end
        end
    end
    return list
end

--- Bodies of exercises are taken out, but for a worked example's; the open edition shows the whole listing.
local function code(page, block)
    local spec = block.attributes.region
    if not spec then return nil end
    local closed = {}
    for id, exercise in pairs(Book.exercises) do closed[id] = not exercise.open end
    local id = spec:match("#(%d+%.%d+)$")
    if id and closed[id] then
        return Report.add(page, Report.line(page, spec),
            "region \"%s\": the body of exercise %s is the reader's: quote the region round it", spec, id) or {}
    end
    local region = Regions.take(page, spec, closed)
    if not region then return {} end
    local language = block.classes[1] or Regions.language(region.path)
    local link = ("source/%s.html#L-%d"):format(region.path, region.first)
    local out = pandoc.List {raw_block('<div class="code">')}
    if region.yours then
        out:extend {Page.only("learner", "", true), pandoc.CodeBlock(region.yours, {class = language}),
            Page.only("learner", "", false), Page.only("open", "", true),
            pandoc.CodeBlock(region.text, {class = language}), Page.only("open", "", false)}
    else
        out:insert(pandoc.CodeBlock(region.text, {class = language}))
    end
    out:insert(raw_block(('<p class="from"><a href="%s">%s</a></p></div>')
        :format(link, Page.escape(region.path .. region.suffix))))
    return out
end

--- Which exercises' bodies the page quotes: id -> path of the file.
local function quoted(page)
    page.quoted = {}
    page.doc:walk {CodeBlock = function(block)
        local spec = block.attributes.region
        if not spec then return end
        local bodies, path = Regions.exercises(spec)
        for id in pairs(bodies) do page.quoted[id] = path end
    end}
end

--- Links between pages are written to the Markdown files; here they become links between the HTML pages.
local function link(page, l)
    if l.target:find("^%a+:") then return nil end
    local figure, state = l.target:match("^([%w_]+)%.png#([%w_]+)$")
    if figure then return Figures.state(page, l, figure, state) end
    local name, anchor = l.target:match("^([^#]*)#?(.*)$")
    name = name:gsub("%.md$", "")
    page.links[#page.links + 1] = {target = l.target, at = Report.line(page, l.target), page = name ~= "" and name or page.name,
                                   anchor = anchor}
    l.target = (name ~= "" and name .. ".html" or "") .. (anchor ~= "" and "#" .. anchor or "")
    return l
end

local function header(page, h)
    local number = page.section_numbers[h.identifier]
    if number and h.level == 2 then
        h.content:insert(1, raw(('<a class="secno" href="#%s">%s</a> '):format(h.identifier, number)))
    end
    return h
end

local function paragraph(page, p)
    if #p.content == 1 and p.content[1].t == "Image" then return Figures.figure(page, p.content[1]) end
    for _, inline in ipairs(p.content) do
        if inline.t == "Image" then
            Report.add(page, Report.line(page, inline.src),
                "the picture " .. inline.src .. " shares its paragraph with text: put empty lines round it")
        end
    end
end

local function weave(page)
    local inlines = {
        Math = function(m) return Book.math(page, m) end,
        RawInline = function(r)
            if r.format == "num" then return raw(Numbers.html(page, r.text, Report.line(page, r.text))) end
        end,
        Cite = function(c) return Labels.resolve(page, c) end,
        Link = function(l) return link(page, l) end,
        Span = function(s) return Claims.span(page, s) end,
        Inlines = keep_together,
    }
    local blocks = {
        CodeBlock = function(b) return code(page, b) end,
        Header = function(h) return header(page, h) end,
        Para = function(p) return paragraph(page, p) end,
        Table = function(t) return {raw_block('<div class="scroll">'), t, raw_block("</div>")} end,
        Div = function(d) return Boxes.div(page, d) end,
    }
    page.inlines = inlines
    quoted(page)
    page.doc = page.doc:walk(inlines)
    Claims.collect(page)
    for _, entry in ipairs(page.contents) do entry.content = pandoc.Inlines(entry.content):walk(inlines) end
    page.doc = page.doc:walk(blocks)
    page.body = Figures.gather_missing(pandoc.write(page.doc, "html5", {wrap_text = "wrap-none"}))
end

local function check_links()
    local ids = {}
    for _, page in ipairs(Book.pages) do
        ids[page.name] = {}
        for id in page.body:gmatch('%sid="([^"]*)"') do ids[page.name][id] = true end
    end
    for _, page in ipairs(Book.pages) do
        for _, l in ipairs(page.links) do
            if not ids[l.page] then
                Report.add(page, l.at, "the link %s leads to no page of this book", l.target)
            elseif l.anchor ~= "" and not ids[l.page][l.anchor] then
                Report.add(page, l.at,
                    "the link %s leads to no place: page %s has no id '%s'", l.target, l.page, l.anchor)
            end
        end
    end
end

local function write_all()
    for _, page in ipairs(Book.pages) do
        Page.write(page.name .. ".html", Page.fill(page, "learner"))
        Page.write("open/" .. page.name .. ".html", Page.fill(page, "open"))
    end
    for path in pairs(Book.sources) do Page.write_source(path) end
    Search.write(Book.pages)
    Claims.write()
    Page.write_lengths()
    Numbers.write_unquoted()
end

function Pandoc()
    for name in env("LIST"):gmatch("%S+") do
        local page = {name = name, file = name .. ".md", links = {}}
        Page.place(page)
        page.text = Page.read(Book.pages_dir .. "/" .. page.file)
        page.doc = pandoc.read(Tables.expand(page), markdown)
        Book.pages[#Book.pages + 1] = page
    end
    Errata.load()
    for _, page in ipairs(Book.pages) do Labels.number(page) end
    Labels.one_example_a_chapter()
    for _, page in ipairs(Book.pages) do Page.minutes(page) end
    for _, page in ipairs(Book.pages) do weave(page) end
    check_links()
    Errata.check_pages()
    write_all()
    if Report.finish() then os.exit(1) end
    return pandoc.Pandoc {}
end
