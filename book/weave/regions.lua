-- Code quoted from the sources by the name of a region: the lines between "// [name]" and "// [/name]",
-- or, for the name "1.3", between "// exercise 1.3" and "// end 1.3". Marks themselves are never shown.
-- Bodies of exercises are the reader's to write: `text` shows them, `yours` has a line "exercise 1.3: yours" instead.
local Regions = {}
local files = {}

local function mark(line)          -- "open"|"close", name
    local text = line:match("^%s*//%s*(.-)%s*$") or line:match("^%s*#%s*(.-)%s*$")
    if not text then return nil end
    local name = text:match("^%[/([%w_.-]+)%]$")
    if name then return "close", name end
    name = text:match("^%[([%w_.-]+)%]$")
    if name then return "open", name end
    name = text:match("^exercise%s+(%d+%.%d+)$")
    if name then return "open", name end
    name = text:match("^end%s+(%d+%.%d+)$")
    if name then return "close", name end
end

local function load(path)
    if files[path] ~= nil then return files[path] end
    local text = Page.read(Book.root .. "/" .. path, true)
    if not text then files[path] = false; return false end
    local file = {lines = {}, regions = {}, text = text}
    for line in (text:gsub("\r\n", "\n"):gsub("\n?$", "\n")):gmatch("(.-)\n") do
        local n = #file.lines + 1
        local kind, name = mark(line)
        file.lines[n] = {text = line, mark = kind ~= nil}
        if kind == "open" then
            if file.regions[name] then file.regions[name].twice = true else file.regions[name] = {first = n + 1} end
        elseif kind == "close" and file.regions[name] then
            file.regions[name].last = n - 1
        end
    end
    files[path] = file
    return file
end

local function is_exercise(name) return name:find("^%d+%.%d+$") ~= nil end

--- The exercises whose bodies stand inside "path#name": id -> {first =, last =}, the path. Silent: take() complains.
function Regions.exercises(spec)
    local path, name = spec:match("^([^#]+)#(.+)$")
    local file, found = load(path or spec), {}
    local all = file and file.regions[name]
    if file and not name then all = {first = 1, last = #file.lines} end
    if not all or not all.last then return found, path end
    for id, body in pairs(file.regions) do
        if is_exercise(id) and id ~= name and body.last and body.first > all.first and body.last < all.last then
            found[id] = body
        end
    end
    return found, path
end

--- How many lines "path#name" quotes without the exercises' bodies in it, and how many each body has. Silent.
function Regions.lengths(spec)
    local path, name = spec:match("^([^#]+)#(.+)$")
    local file = load(path or spec)
    local region = file and (name and file.regions[name] or not name and {first = 1, last = #file.lines})
    if not region or not region.last then return 0, {} end
    local lines, bodies = region.last - region.first + 1, {}
    for id, body in pairs(Regions.exercises(spec)) do
        bodies[id] = body.last - body.first + 1
        lines = lines - bodies[id] - 1
    end
    return lines, bodies
end

--- What "path#name" quotes, its indent taken away; nil after a complaint.
--- text: all of it; yours: with the bodies of the exercises in `closed` (a set of ids) taken out, nil if there are none.
function Regions.take(page, spec, closed)
    local at = Report.line(page, spec)
    local path, name = spec:match("^([^#]+)#(.+)$")
    path = path or spec
    local file = load(path)
    if not file then
        Report.add(page, at, "region \"%s\": there is no file %s", spec, path)
        return nil
    end
    local region = name and file.regions[name] or {first = 1, last = #file.lines}
    if name and not file.regions[name] then
        Report.add(page, at, "region \"%s\": no region '%s' in %s (%s)", spec, name, path,
            Report.names(file.regions, "it has none: put // [" .. name .. "] and // [/" .. name .. "] round the lines"))
        return nil
    elseif not region.last then
        Report.add(page, at, "region \"%s\": the region is opened and never closed in %s", spec, path)
        return nil
    elseif region.twice then
        Report.add(page, at, "region \"%s\": the name is opened twice in %s", spec, path)
        return nil
    end
    local lines, indent, first = {}, 999, nil
    for n = region.first, region.last do
        if not file.lines[n].mark then
            local text = file.lines[n].text
            if text:find("%S") then
                first = first or n
                indent = math.min(indent, #text:match("^%s*"))
            end
            if first then lines[#lines + 1] = text end
        end
    end
    while #lines > 0 and not lines[#lines]:find("%S") do lines[#lines] = nil end
    if #lines == 0 then
        Report.add(page, at, "region \"%s\": the region is empty", spec)
        return nil
    end
    local yours = Regions.without_bodies(file, spec, region, closed or {}, indent)
    for i, text in ipairs(lines) do lines[i] = text:sub(indent + 1) end
    Regions.check_equations(page, at, spec, lines)
    Book.sources[path] = file.text
    local suffix = name and (is_exercise(name) and ", exercise " .. name or ", " .. name) or ""
    return {text = table.concat(lines, "\n"), yours = yours, path = path, first = first, suffix = suffix}
end

--- The same lines with each closed body replaced by one line that says whose it is; nil if no body is closed.
function Regions.without_bodies(file, spec, region, closed, indent)
    local starts, any = {}, false
    for id, body in pairs(Regions.exercises(spec)) do
        if closed[id] then starts[body.first] = {id = id, last = body.last}; any = true end
    end
    if not any then return nil end
    local lines, n = {}, region.first
    while n <= region.last do
        local text, body = file.lines[n].text, starts[n]
        if body then
            lines[#lines + 1] = text:match("^%s*"):sub(indent + 1) .. "// exercise " .. body.id .. ": yours"
            n = body.last
        elseif not file.lines[n].mark and (#lines > 0 or text:find("%S")) then
            lines[#lines + 1] = text:sub(indent + 1)
        end
        n = n + 1
    end
    return (table.concat(lines, "\n"):gsub("%s+$", ""))
end

--- Where quoted code says "eq. (1.a)", chapter 1 has such an equation.
function Regions.check_equations(page, at, spec, lines)
    for number, letters in table.concat(lines, "\n"):gmatch("[Ee]qs?%. %((%d+%u?)%.(%l%l?)%)") do
        local label = ("(%s.%s)"):format(number, letters)
        local chapter, found
        for _, other in ipairs(Book.pages) do
            if other.number == number then
                chapter = other
                for _, l in pairs(other.labels) do found = found or l.text == label end
            end
        end
        if chapter and not found then
            Report.add(page, at,
                "region \"%s\" names equation %s, and page %s has none of that number", spec, label, chapter.name)
        end
    end
end

function Regions.language(path)
    local by_ending = {hpp = "cpp", cpp = "cpp", h = "cpp", sh = "bash", txt = "cmake", lua = "lua", csv = "default"}
    return by_ending[path:match("%.(%w+)$") or ""] or (path:find("[^.]*$") and "bash")
end

return Regions
