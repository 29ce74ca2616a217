-- What can be referred to: equations, figures, sections, exercises, errata. Numbers are given in the order of the page.
--   {#eq:14} the source's (14)   {#eq:8-9} (8–9)   {#eq:11star erratum=E05} the corrected (11*)   {#eq:turn} ours, (1.a)
--   {#fig:planet} Figure 1.2     {#sec:ball} Section 1.3     {.exercise #ex:1.3} Exercise 1.3     [@E05] an erratum
-- A reference means its own page first, then the one other page that has the label; [@02_revised_newton/eq:11] names the page.
local Labels = {}
local by_id = {}                                    -- id -> list of {page =, text =}

local function put(page, id, text)
    if page.labels[id] then
        Report.line(page, "#" .. id)
        Report.add(page, Report.line(page, "#" .. id), "the label %s is given twice on this page", id)
        return
    end
    page.labels[id] = {text = text, href = page.name .. ".html#" .. id}
    by_id[id] = by_id[id] or {}
    table.insert(by_id[id], page)
end

local function letters(n)                           -- 1 -> a, 27 -> aa
    local text = ""
    while n > 0 do
        text = string.char(97 + (n - 1) % 26) .. text
        n = (n - 1) // 26
    end
    return text
end

local function dotted(page, n) return page.number and page.number .. "." .. n or tostring(n) end

--- The number an equation shows, from its label: text, starred?
local function equation_number(page, name)
    local first, last, star = name:match("^(%d+)%-?(%d*)(s?t?a?r?)$")
    if first and (star == "" or star == "star") then
        return "(" .. first .. (last ~= "" and "–" .. last or "") .. (star ~= "" and "*" or "") .. ")", star ~= "", first, last
    end
    page.own_equations = page.own_equations + 1
    return "(" .. (page.number and page.number .. "." or "") .. letters(page.own_equations) .. ")", false
end

local function equation(page, div)
    local name = div.identifier:sub(4)
    local text, star, first, last = equation_number(page, name)
    put(page, div.identifier, text)
    if last and last ~= "" then                     -- (8–9) answers to eq:8 and eq:9 too
        for n = tonumber(first), tonumber(last) do
            local id = "eq:" .. n .. (star and "star" or "")
            local own = "(" .. n .. (star and "*" or "") .. ")"
            page.labels[id] = page.labels[id] or {text = own, href = page.name .. ".html#" .. div.identifier}
            by_id[id] = by_id[id] or {}
            table.insert(by_id[id], page)
        end
    end
    local erratum = div.attributes.erratum
    if star and not erratum then
        Report.add(page, Report.line(page, "#" .. div.identifier),
            "equation %s is a corrected one: say which erratum, {#%s erratum=E..}", text, div.identifier)
    end
end

local function header(page, h)
    if h.level == 1 then
        page.title = page.title or pandoc.utils.stringify(h.content)
        put(page, h.identifier, Page.kicker(page) or page.title)
    elseif h.level == 2 then
        local number
        if page.chapter and not h.classes:includes("unnumbered") then
            page.sections = page.sections + 1
            number = dotted(page, page.sections)
            page.section_numbers[h.identifier] = number
        end
        page.contents[#page.contents + 1] = {id = h.identifier, number = number, content = h.content:clone()}
        put(page, h.identifier, number and "Section " .. number or pandoc.utils.stringify(h.content))
    end
end

--- Exercises are collected over all pages: a body is closed wherever it is quoted.
local function exercise(page, div)
    local id = div.identifier:sub(4)
    put(page, div.identifier, "Exercise " .. id)
    page.exercises[#page.exercises + 1] = {id = id, title = div.attributes.title or ""}
    Book.exercises[id] = {page = page, open = div.classes:includes("open")}
end

function Labels.number(page)
    page.labels, page.section_numbers, page.contents, page.exercises = {}, {}, {}, {}
    page.own_equations, page.figures, page.sections = 0, 0, 0
    page.doc:walk {
        traverse = "topdown",
        Header = function(h) header(page, h) end,
        Div = function(d)
            if d.identifier:find("^eq:") then equation(page, d)
            elseif d.identifier:find("^ex:") then exercise(page, d) end
        end,
        Image = function(i)
            if i.identifier:find("^fig:") then
                page.figures = page.figures + 1
                put(page, i.identifier, "Figure " .. dotted(page, page.figures))
            end
        end,
    }
    page.found = {}                                 -- the second pass searches from the top again
    if not page.title then
        page.title = page.name
        Report.add(page, 1, "the page has no title: begin with '# Title {#sec:name}'")
    end
end

--- The bodies are the reader's to write; one a chapter may stand open.
function Labels.one_example_a_chapter()
    local open = {}
    for _, page in ipairs(Book.pages) do
        for _, e in ipairs(page.exercises) do
            if Book.exercises[e.id].open then
                if open[page.chapter] then
                    Report.add(page, Report.line(page, "#ex:" .. e.id),
                        "exercise %s is open, and %s is already this chapter's worked example", e.id, open[page.chapter])
                end
                open[page.chapter] = e.id
            end
        end
    end
end

--- Text and address of a reference, or nil after a complaint.
local function find(page, key, at)
    if key:find("^E%d%d$") then
        if not Errata.by_id[key] then
            Report.add(page, at, "unknown reference @%s: errata.csv has no such row", key)
            return nil
        end
        return {text = key, href = "errata.html#" .. key}
    end
    local name, id = key:match("^([%w_]+)/(.+)$")
    id = id or key
    if not name and page.labels[id] then return page.labels[id] end
    local pages = {}
    for _, other in ipairs(by_id[id] or {}) do
        if not name or other.name == name then pages[#pages + 1] = other end
    end
    if #pages == 1 then return pages[1].labels[id] end
    if #pages == 0 then
        Report.add(page, at, "unknown reference @%s: %s", key, Labels.nearest(id))
    else
        Report.add(page, at,
            "ambiguous reference @%s: write @%s/%s or @%s/%s", key, pages[1].name, id, pages[2].name, id)
    end
end

--- Whether [@key] would find its place.
function Labels.known(page, key)
    local name, id = key:match("^([%w_]+)/(.+)$")
    if not name and page.labels[key] then return true end
    for _, other in ipairs(by_id[id or key] or {}) do
        if not name or other.name == name then return true end
    end
    return false
end

function Labels.nearest(id)
    local kind, list = id:match("^(%a+:)"), {}
    if not kind then return "a reference is @eq:…, @fig:…, @sec:…, @ex:N.M or @E05" end
    for known, pages in pairs(by_id) do
        if known:sub(1, #kind) == kind then list[known] = true end
    end
    return Report.names(list, "no page has a label that begins with " .. kind)
end

function Labels.resolve(page, cite)
    local out = pandoc.List()
    for i, c in ipairs(cite.citations) do
        local at = Report.line(page, "@" .. c.id)
        local label = find(page, c.id, at)
        if i > 1 then out:insert(pandoc.Str(i == #cite.citations and " and " or ", ")) end
        if #c.prefix > 0 then out:extend(c.prefix); out:insert(pandoc.Space()) end
        if label then
            local href = label.href:gsub("^" .. page.name:gsub("%p", "%%%0") .. "%.html", "")
            local text = Page.escape(label.text):gsub(" ", "\u{a0}")
            out:insert(pandoc.RawInline("html", ('<a class="ref" href="%s">%s</a>'):format(href, text)))
        else
            out:insert(pandoc.Str("?"))
        end
        out:extend(c.suffix)
    end
    return out
end

return Labels
