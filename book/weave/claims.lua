-- Claims: what stands behind each sentence that says a number or compares. A number woven in stands behind its sentence;
-- other claims say what does, and the build checks it:
--   [Verlet is the worse of the two]{by="falling.verlet.steps > falling.euler.steps"}      numbers of this build: < > <= >=, joined by "and";
--                                                          a term is NAME, a number, NAME*2 or NAME/2
--   [nothing allocates]{by="test: a step of many particles asks for no memory"}            a test of that name
--   [it spirals outwards]{by="eq:spiral"}                                                  derived there: eq:, sec:, fig:, ex:
--   [the best method we have]{by="words"}                                                  no claim about the world
-- claims.csv lists all sentences with what stands behind them; `book/build.sh --claims` prints it.
local Claims = {rows = {}}

local comparing = {}
for word in ([[better worse best worst faster slower fastest slowest cheaper cheapest dearer fewer fewest less least more most larger largest
    smaller smallest higher highest lower lowest nearer farther farthest finer coarser steeper longer longest shorter shortest twice thrice
    never always doubles halves outperforms exactly identical greater greatest bigger biggest stronger strongest weaker weakest closer closest
    steepest shallower tighter earlier sooner quicker lighter heavier shorten simpler harder easier poorer richer]]):gmatch("%S+") do comparing[word] = true end

local tests
local function test_exists(name)
    if not tests then
        tests = {}
        local pipe = io.popen("find '" .. Book.root .. "/tests' -name '*.cpp' -o -name CMakeLists.txt 2>/dev/null")
        for path in pipe:lines() do
            local text = Page.read(path, true) or ""
            for title in text:gmatch('add_test%(NAME "([^"]+)"') do tests[title] = true end
            for call in text:gmatch('TEST_CASE(%b())') do
                local title, at = "", 2
                while true do                       -- adjacent literals are one name
                    local from, to, piece = call:find('^%s*"([^"]*)"', at)
                    if not from then break end
                    title, at = title .. piece, to + 1
                end
                tests[title] = true
            end
        end
        pipe:close()
    end
    if tests[name] then return true end
    for title in pairs(tests) do                    -- the beginning of a name will do, if it is long
        if #name >= 24 and title:sub(1, #name) == name then return true end
    end
    return false
end

local function term(page, text)
    if tonumber(text) then return tonumber(text) end
    local name, operator, factor = text:match("^(.-)%s*([*/])%s*([%d.]+)$")
    if not name then name, operator = text, "" end
    if not name:find("^[%w_./-]+$") then return nil, "'" .. text .. "' is no number, NAME, NAME*2 or NAME/2" end
    local value, why = tonumber(name)
    if not value then value, why = Numbers.value(page, name) end
    if not value then return nil, why end
    if operator == "*" then value = value * tonumber(factor) elseif operator == "/" then value = value / tonumber(factor) end
    return value
end

local holds = {["<"] = function(a, b) return a < b end, [">"] = function(a, b) return a > b end,
               ["<="] = function(a, b) return a <= b end, [">="] = function(a, b) return a >= b end}

--- nil if `by` stands, else why not
local function doubt(page, by)
    if by == "words" then return nil end
    local name = by:match("^test:%s*(.+)$")
    if name then return not test_exists(name) and "there is no such test" or nil end
    if by:find("^%a+:%S+$") or by:find("^[%w_]+/%a+:%S+$") then return not Labels.known(page, by) and "there is no such label" or nil end
    for part in (by .. " and "):gmatch("(.-)%s+and%s+") do
        local left, operator, right = part:match("^%s*(.-)%s*([<>]=?)%s*(.-)%s*$")
        if not left then return "it is neither 'test: …', a label, 'words' nor a comparison" end
        local a, why_a = term(page, left)
        local b, why_b = term(page, right)
        if not a or not b then return why_a or why_b end
        if not holds[operator](a, b) then return ("%s %s %s does not hold: %g and %g"):format(left, operator, right, a, b) end
    end
end

--- A span with by="…": checked, and what stands behind it in its tooltip.
function Claims.span(page, span)
    local by = span.attributes.by
    if not by then return nil end
    local why = doubt(page, by)
    if why then Report.add(page, Report.line(page, by), "claim by \"%s\": %s", by, why) end
    local out = pandoc.List {pandoc.RawInline("html", ('<span class="claim" data-by="%s">'):format(Page.escape(by)))}
    out:extend(span.content)
    out:insert(pandoc.RawInline("html", "</span>"))
    return out
end

-- --- the list ---------------------------------------------------------------------------------------------------

local function unescape(text)
    return (text:gsub("&lt;", "<"):gsub("&gt;", ">"):gsub("&quot;", '"'):gsub("&amp;", "&"))
end

local function flat(inlines, out)
    for _, i in ipairs(inlines) do
        if i.t == "RawInline" then
            local behind = i.text:match('class="num" title="([^"]*)"') or i.text:match('data%-by="([^"]*)"')
            out[#out + 1] = {text = unescape((i.text:gsub("<[^>]*>", ""))), behind = behind and unescape(behind)}
        elseif i.t == "Space" or i.t == "SoftBreak" or i.t == "LineBreak" then out[#out + 1] = {text = " ", space = true}
        elseif i.t == "Image" then flat(i.caption, out)
        elseif i.t == "Quoted" then
            out[#out + 1] = {text = "“"}
            flat(i.content, out)
            out[#out + 1] = {text = "”"}
        elseif i.content then flat(i.content, out)
        else out[#out + 1] = {text = i.text or "", plain = i.t == "Str"} end
    end
    return out
end

local function sentence(page, parts)
    local text, behind, compares, given = "", {}, nil, false
    local before = ""                                       -- "chapter 3", "exercise 3.7", "RK4" count nothing
    for _, p in ipairs(parts) do
        text = text .. p.text
        if p.behind then behind[#behind + 1] = p.behind end
        if p.plain then
            local word = p.text:lower():gsub("^%p+", ""):gsub("%p+$", "")
            compares = compares or comparing[word] and word
            local names = before:lower():find("^%p*chapters?$") or before:lower():find("^%p*exercises?$") or p.text:find("^%p*%a+%d")
                or p.text:find("^%p*%d%u%p*$") or p.text:find("^%(%d+%*?%)")
            given = given or p.text:find("%d") and not names
            before = p.text
        end
    end
    text = text:gsub("%s+", " "):match("^%s*(.-)%s*$")
    if #behind == 0 and (text:find("%?$") or not compares and not given) then return end    -- a question claims nothing
    local kind = #behind > 0 and "held" or compares and "bare" or "given"
    Claims.rows[#Claims.rows + 1] = {page = page.file, kind = kind, text = text,
                                     behind = #behind > 0 and table.concat(behind, "; ") or compares or ""}
end

--- Collects the sentences of a page whose inlines are woven.
function Claims.collect(page)
    if not page.chapter then return end
    local function paragraph(p)
        local parts = {}
        local all = flat(p.content, {})
        for n, part in ipairs(all) do
            parts[#parts + 1] = part
            local next = all[n + 1]
            if part.text:find("[.?!]['\")”]*$") and (not next or next.space) then sentence(page, parts); parts = {} end
        end
        if #parts > 0 then sentence(page, parts) end
    end
    page.doc:walk {Para = paragraph, Plain = paragraph}
end

function Claims.write()
    local function quoted(text) return '"' .. text:gsub('"', '""') .. '"' end
    local lines = {"page,kind,behind,sentence"}
    for _, r in ipairs(Claims.rows) do
        lines[#lines + 1] = table.concat({r.page, r.kind, quoted(r.behind), quoted(r.text)}, ",")
    end
    Page.write("claims.csv", table.concat(lines, "\n") .. "\n")
end

return Claims
