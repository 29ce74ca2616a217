-- Numbers of the text, from the numbers.csv that the chapters' programs wrote in this build.
--   `planet.axis_turn %.2e rad`{=num}     in text         \num{planet.axis_turn %.2e rad}     in formulas
--   NAME [abs] [*FACTOR or /DIVISOR] [%FORMAT] [UNIT]; NAME of another chapter: 03_forces/NAME; UNIT "unit" takes the file's.
local Numbers = {}
local tables = {}
local thin, narrow = "\u{2009}", "\u{202F}"

function Numbers.load(chapter)
    if tables[chapter] then return tables[chapter] end
    local path = Book.results .. "/" .. chapter .. "/numbers.csv"
    local t = {values = {}}
    tables[chapter] = t
    local text = Page.read(path, true)
    if not text then
        t.missing = ("%s/numbers.csv is not there: run ./course run %d first")
            :format(chapter, tonumber(chapter:match("^%d+")) or 0)
        return t
    end
    local rows, line, why = Csv.parse(text)
    if not rows then t.missing = ("%s/numbers.csv, line %d: %s"):format(chapter, line, why); return t end
    for i = 2, #rows do
        local row = rows[i]
        if row[1] and row[1] ~= "" then
            t.values[row[1]] = {value = tonumber(row[2]), text = row[2], unit = row[3] or "", shown = row[4] or ""}
        end
    end
    return t
end

--- A number for a comparison; nil and why not
function Numbers.value(page, full)
    local chapter, name = full:match("^([^/]+)/(.+)$")
    if not chapter then chapter, name = page.results, full end
    if not chapter then return nil, "this page is no chapter: say whose number, 01_newton/" .. full end
    local t = Numbers.load(chapter)
    if t.missing then return nil, t.missing end
    local entry = t.values[name]
    if entry then entry.quoted = true end
    if not entry or not entry.value then
        return nil, ("no such name in %s/numbers.csv (%s)"):format(chapter, Numbers.nearest(t.values, name))
    end
    return entry.value
end

--- A value as `words` ask for: abs, a factor, a format, a unit. {sign, digits, exponent or nil, unit}; nil and why not
function Numbers.shape(value, words, file_unit)
    local format, unit = "%.3g", {}
    for _, word in ipairs(words) do
        local operator, factor = word:match("^([*/])([%d.eE+-]+)$")
        if word == "abs" then value = math.abs(value)
        elseif operator and tonumber(factor) and #unit == 0 then
            value = operator == "*" and value * tonumber(factor) or value / tonumber(factor)
        elseif word:find("^%%[-+ #0]*%d*%.?%d*[efgd]$") then format = word
        elseif word == "unit" and #unit == 0 then unit[1] = file_unit
        elseif word:find("^%%.") then return nil, "format " .. word .. " is none of %d %f %e %g"
        else unit[#unit + 1] = word end
    end
    if format:find("d$") then
        if value ~= math.floor(value) then return nil, ("%s wants a whole number, it is %s"):format(format, value) end
        value = math.tointeger(value) or value
    end
    local text = string.format(format, value)
    local sign, digits, exponent = text:match("^%s*([-+]?)([%d.]+)[eE]?([-+]?%d*)%s*$")
    if sign == "-" and not digits:find("[1-9]") then sign = "" end
    return {sign = sign, digits = digits, exponent = tonumber(exponent), unit = table.concat(unit, " ")}
end

--- {sign, digits, exponent or nil, unit, title}; nil after a complaint
local function take(page, spec, at)
    local function complain(what)
        Report.add(page, at, "number `%s`: %s", spec, what)
    end
    local words = {}
    for word in spec:gmatch("%S+") do words[#words + 1] = word end
    local full = table.remove(words, 1) or ""
    local chapter, name = full:match("^([^/]+)/(.+)$")
    if not chapter then chapter, name = page.results, full end
    if full:find("^page%.") then                         -- the page's own: how long it takes
        local minutes = page.minutes and page.minutes[full:sub(6)]
        if not minutes then return complain("a page knows page.reading and page.exercises, in minutes") end
        return {sign = "", digits = tostring(minutes), unit = table.concat(words, " "):gsub("^%%d%s*", ""), title = "reckoned from the page"}
    end
    if not chapter then return complain("this page is no chapter: say whose number, 01_newton/" .. full) end
    local t = Numbers.load(chapter)
    if t.missing then                                    -- once is enough
        if not t.told then complain(t.missing) end
        t.told = true
        return nil
    end
    local entry = t.values[name]
    if not entry then
        return complain(("no such name in %s/numbers.csv (%s)"):format(chapter, Numbers.nearest(t.values, name)))
    end
    entry.quoted = true
    local value = entry.value
    if not value or value ~= value or value == math.huge or value == -math.huge then
        return complain(("its value is %s, not a finite number"):format(entry.text))
    end
    local n, why = Numbers.shape(value, words, entry.unit)
    if not n then return complain(why) end
    n.title = ("%s/%s = %s%s"):format(chapter, name, entry.text, entry.unit ~= "" and " " .. entry.unit or "")
    return n
end

--- names that share the most leading letters with the one that was asked for
function Numbers.nearest(values, name)
    local best, list = 0, {}
    for candidate in pairs(values) do
        local same = 0
        while same < #name and candidate:sub(same + 1, same + 1) == name:sub(same + 1, same + 1) do same = same + 1 end
        if same > best then best, list = same, {} end
        if same == best then list[candidate] = true end
    end
    return Report.names(list, "it is empty")
end

local function grouped(digits, separator)          -- 16000 -> 16 000
    local whole, rest = digits:match("^(%d+)(.*)$")
    if #whole >= 5 then
        whole = whole:reverse():gsub("(%d%d%d)", "%1 "):reverse():gsub("^ ", ""):gsub(" ", separator)
    end
    return whole .. rest
end

--- A number as HTML, what it was in its tooltip.
function Numbers.span(n)
    local text = (n.sign == "-" and "\u{2212}" or n.sign) .. grouped(n.digits, narrow)
    if n.exponent and n.exponent ~= 0 then
        text = ("%s%s×%s10<sup>%s%d</sup>"):format(text, thin, thin, n.exponent < 0 and "\u{2212}" or "", math.abs(n.exponent))
    end
    if n.unit ~= "" then
        local unit = Page.escape(n.unit):gsub("%^(%-?%d+)", function(e) return "<sup>" .. e:gsub("-", "\u{2212}") .. "</sup>" end)
        text = text .. (n.unit:find("^[%%°]") and "" or "\u{a0}") .. unit
    end
    return ('<span class="num" title="%s">%s</span>'):format(Page.escape(n.title), text)
end

function Numbers.html(page, spec, at)
    local n = take(page, spec, at)
    return n and Numbers.span(n) or "?"
end

function Numbers.tex(page, spec, at)
    local n = take(page, spec, at)
    if not n then return "?" end
    local text = n.sign .. grouped(n.digits, "\\,")
    if n.exponent and n.exponent ~= 0 then text = text .. "\\times 10^{" .. n.exponent .. "}" end
    if n.unit ~= "" then text = text .. (n.unit:find("^%%") and "\\%%" or "\\,\\mathrm{" .. n.unit .. "}") end
    return text
end

--- Numbers of the chapters that have a page which no page quotes and no chart shows.
function Numbers.write_unquoted()
    local lines = {}
    for _, page in ipairs(Book.pages) do if page.results then Numbers.load(page.results) end end
    for chapter, t in pairs(tables) do
        for name, entry in pairs(t.values) do
            if not entry.quoted and entry.shown == "" then lines[#lines + 1] = chapter .. "/" .. name end
        end
    end
    table.sort(lines)
    Page.write("unquoted.txt", #lines > 0 and table.concat(lines, "\n") .. "\n" or "")
end

return Numbers
