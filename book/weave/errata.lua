-- errata.csv: one row per defect of the source document; the errata page shows them all, equations and boxes link to them.
-- Cells are Markdown (formulas in $…$, code in `…`). lives: entries separated by ';', each one of
--   mistake: NAME | test: NAME | page: PAGE#ANCHOR | wording | planned: chapter N
local Errata = {by_id = {}, list = {}}
local file = {file = "errata.csv"}
local columns = {"id", "where", "printed", "correct", "severity", "lives"}

function Errata.load()
    local text = Page.read(Book.pages_dir .. "/errata.csv", true)
    if not text then return end
    local rows, line, why = Csv.parse(text)
    if not rows then return Report.add(file, line, why) end
    for i, row in ipairs(rows) do
        if #row ~= #columns then
            Report.add(file, row.line, "a row has %d cells, this one has %d", #columns, #row)
        elseif i > 1 then
            local entry = {line = row.line}
            for c, name in ipairs(columns) do entry[name] = row[c] end
            if Errata.by_id[entry.id] then Report.add(file, row.line, entry.id .. " is there twice") end
            entry.pages = {}
            for name, anchor in entry.lives:gmatch("page:%s*([%w_]+)#?([^;%s]*)") do
                table.insert(entry.pages, {name = name, anchor = anchor})
            end
            Errata.by_id[entry.id] = entry
            Errata.list[#Errata.list + 1] = entry
        end
    end
end

local function lives_html(page, entry)
    local out = {}
    for item in entry.lives:gmatch("[^;]+") do
        item = item:match("^%s*(.-)%s*$")
        local kind, what = item:match("^(%a+):%s*(.+)$")
        local html
        if item == "wording" then
            html = "wording only"
        elseif kind == "page" then
            local name, anchor = what:match("^([%w_]+)#?(.*)$")
            html = ('shown on <a href="%s.html%s">%s</a>')
                :format(name, anchor ~= "" and "#" .. anchor or "", Errata.place(name, anchor))
        elseif kind == "planned" then
            html = "planned: " .. Page.escape(what)
        elseif kind == "mistake" or kind == "test" then
            html = ("%s <code>%s</code>"):format(kind, Page.escape(what))
        else
            Report.add(file, entry.line,
                "%s lives in '%s': say mistake:, test:, page:, wording or planned:", entry.id, item)
        end
        out[#out + 1] = html and "<li>" .. html .. "</li>" or ""
    end
    return '<ul class="lives">' .. table.concat(out) .. "</ul>"
end

--- "Chapter 1, (14*)": how a place on a page is called
function Errata.place(name, anchor)
    for _, page in ipairs(Book.pages) do
        if page.name == name then
            local where = (Page.kicker(page) or page.title):gsub("^Chapter", "chapter")
            return Page.escape(where .. (page.labels[anchor] and ", " .. page.labels[anchor].text or ""))
        end
    end
    return Page.escape(name)
end

function Errata.check_pages()
    local ids = {}
    for _, page in ipairs(Book.pages) do
        ids[page.name] = {[""] = true}
        for id in page.body:gmatch('%sid="([^"]*)"') do ids[page.name][id] = true end
    end
    for _, entry in ipairs(Errata.list) do
        for _, p in ipairs(entry.pages) do
            if not ids[p.name] or not ids[p.name][p.anchor] then
                Report.add(file, entry.line,
                    "%s lives on page %s#%s, and there is no such place", entry.id, p.name, p.anchor)
            end
        end
    end
end

--- The table, with an anchor for each row.
function Errata.rows(page)
    local source = {}
    for _, e in ipairs(Errata.list) do
        for _, cell in ipairs {e.where, e.printed, e.correct} do source[#source + 1] = "::: cell\n" .. cell .. "\n:::\n" end
    end
    local as_page = {file = "errata.csv", text = Page.read(Book.pages_dir .. "/errata.csv", true) or ""}
    local cells = {}
    local blocks = pandoc.read(table.concat(source, "\n"), "markdown").blocks
    for _, div in ipairs(blocks) do cells[#cells + 1] = div.content end
    local out = pandoc.List {pandoc.RawBlock("html", '<table class="errata"><thead><tr><th>Where</th>'
        .. '<th>Printed</th><th>Correct</th><th>Lives</th></tr></thead><tbody>')}
    local function put(html) out:insert(pandoc.RawBlock("html", html)) end
    for i, e in ipairs(Errata.list) do
        put(('<tr id="%s"><td class="where"><a class="id" href="#%s">%s</a> <span class="place">'):format(e.id, e.id, e.id))
        out:extend(cells[3 * i - 2])
        put(('</span> <span class="severity %s">%s</span></td><td data-label="Printed">')
            :format(e.severity:match("^%w+"), Page.escape(e.severity)))
        out:extend(cells[3 * i - 1])
        put('</td><td data-label="Correct">')
        out:extend(cells[3 * i])
        put(('</td><td class="where-now" data-label="Lives">%s</td></tr>'):format(lives_html(page, e)))
    end
    put("</tbody></table>")
    local woven = {}
    for k, f in pairs(page.inlines) do woven[k] = f end
    woven.Math = function(m) return Book.math(as_page, m) end
    return pandoc.Blocks(out):walk(woven)
end

return Errata
