-- Tables whose rows stand in a CSV of the chapter's results. Of such a table one row is written, and repeated for each row of the file:
--   ::: {.table from="limits.csv" only="Euler; RK4"}       only= or but= choose rows by the file's first column
--   | method | undamped |
--   |---|---|
--   | `method`{=cell} | `undamped undamped_found %.3f`{=cell} |
--   :::
-- A cell is COLUMN... and the rest as of a number; several columns stand with a dot between them, empty ones are left out.
local Tables = {}

local function split(text)
    local list = {}
    for word in ((text or "") .. ";"):gmatch("%s*(.-)%s*;") do if word ~= "" then list[#list + 1] = word end end
    return list
end

local function open(page, attributes, at)
    local function complain(...) Report.add(page, at, ...); return {rows = {}, columns = {}} end
    local file = attributes:match('from="([^"]*)"')
    if not file then return complain('a table says where its rows stand: ::: {.table from="limits.csv"}') end
    local chapter = page.results
    if file:find("/") then chapter, file = file:match("^([^/]+)/(.+)$") end
    if not chapter then return complain("this page is no chapter: say whose file, 01_newton/%s", file) end
    local text = Page.read(Book.results .. "/" .. chapter .. "/" .. file, true)
    if not text then return complain("there is no %s/%s: run its chapter, or look for its name in out/", chapter, file) end
    local all, line, why = Csv.parse(text)
    if not all then return complain("%s/%s, line %d: %s", chapter, file, line, why) end
    local box = {file = chapter .. "/" .. file, rows = {}, columns = {}}
    for i, name in ipairs(all[1]) do box.columns[name] = i end
    local first, names = {}, {}
    for i = 2, #all do first[all[i][1]] = all[i]; names[all[i][1]] = true end
    local only, but = split(attributes:match('only="([^"]*)"')), split(attributes:match('but="([^"]*)"'))
    local left_out = {}
    for _, list in ipairs {only, but} do
        for _, name in ipairs(list) do
            if not first[name] then Report.add(page, at, "%s has no row '%s' (%s)", box.file, name, Report.names(names)) end
        end
    end
    for _, name in ipairs(but) do left_out[name] = true end
    if #only > 0 then
        for _, name in ipairs(only) do box.rows[#box.rows + 1] = first[name] end
    else
        for i = 2, #all do if not left_out[all[i][1]] then box.rows[#box.rows + 1] = all[i] end end
    end
    return box
end

local function cell(page, box, row, spec, at)
    local values, words, found = {}, {}, false
    for word in spec:gmatch("%S+") do
        local column = box.columns[word]
        if column and #words == 0 then
            found = true
            if (row[column] or "") ~= "" then
                values[#values + 1] = {text = row[column], title = ("%s, %s, %s = %s"):format(box.file, row[1], word, row[column])}
            end
        else
            words[#words + 1] = word
        end
    end
    if not found then
        Report.add(page, at, "cell `%s`: %s has no such column (%s)", spec, box.file or "the file", Report.names(box.columns))
    end
    local out = {}
    for _, v in ipairs(values) do
        local number = tonumber(v.text) or v.text == "inf" and math.huge
        if not number then out[#out + 1] = Page.escape(v.text)
        elseif number == math.huge then out[#out + 1] = "∞"
        else
            local n, why = Numbers.shape(number, words)
            if not n then Report.add(page, at, "cell `%s`: %s", spec, why); return "?" end
            n.title = v.title
            out[#out + 1] = number == 0 and "0" or Numbers.span(n)
        end
    end
    return "`" .. table.concat(out, " · "):gsub("|", "&#124;"):gsub("`", "&#96;") .. "`{=html}"
end

--- The page's text, with the rows of such tables written out. Lines keep their numbers up to the first table; complaints look in the source.
function Tables.expand(page)
    local out, box, at = {}, nil, 0
    for line in (page.text .. "\n"):gmatch("(.-)\n") do
        at = at + 1
        local attributes = line:match("^:::%s*{%.table%s*(.-)}%s*$")
        if attributes then
            box = open(page, attributes, at)
            out[#out + 1] = ""
        elseif box and line:find("^:::%s*$") then
            box = nil
            out[#out + 1] = ""
        elseif box and line:find("{=cell}", 1, true) then
            for _, row in ipairs(box.rows) do
                out[#out + 1] = (line:gsub("`([^`]*)`{=cell}", function(spec) return cell(page, box, row, spec, at) end))
            end
        else
            out[#out + 1] = line
        end
    end
    return table.concat(out, "\n")
end

return Tables
