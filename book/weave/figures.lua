-- Figures: pictures (.png, copied) and charts (.svg, put into the page, so that tooltips and dark mode work).
--   ![Caption.](planet.png){#fig:planet}     alone in its paragraph; another chapter's: 03_forces/chain.png
--   attributes: command="…" (else the picture's .txt says it), alt="…", width=60%
-- A picture whose .txt says "not drawn: REASON" was declared and could not be drawn: the page says so in its place.
local Figures = {}

local function note(path)                           -- the picture's .txt: "key: value" lines
    local text = Page.read(path, true)
    if not text then return nil end
    local fields = {}
    for key, value in text:gmatch("([%w_ -]+):[ \t]*([^\r\n]*)") do
        key = key:lower():match("^%s*(.-)%s*$")
        fields[key] = fields[key] or value
    end
    return fields
end

local function png_size(bytes)
    if bytes:sub(2, 4) ~= "PNG" then return nil end
    return string.unpack(">I4I4", bytes, 17)
end

--- A chart as it came from the chart writer, which keeps ids and style rules to the chart's own id: many fit on a page.
local function chart(page, at, src, svg)
    svg = svg:gsub("^%s*<%?xml.-%?>", "")
    local root = svg:match("<svg[^>]*>") or ""
    local id = root:match("%sid=['\"]([^'\"]+)")
    page.charts = page.charts or {}
    if not root:find("class=['\"]chart['\"]") or not id then
        return Report.add(page, at,
            "picture %s: the SVG is not from our chart writer (class='chart', an id of its own)", src)
    elseif page.charts[id] then
        return Report.add(page, at, "picture %s: the same chart is on this page already", src)
    end
    page.charts[id] = true
    return '<div class="plot">' .. svg .. "</div>"
end

--- A caption as plain text, for readers who do not see the picture; numbers and formulas are woven in already.
local function spoken(caption)
    local text = pandoc.Inlines(caption):walk {
        RawInline = function(r) return pandoc.Str((r.text:gsub("<[^>]*>", ""))) end,
        Str = function(s) return pandoc.Str(Page.escape(s.text)) end,
    }
    return pandoc.utils.stringify(text)
end

local function alternative(image)
    return image.attributes.alt and Page.escape(image.attributes.alt) or spoken(image.caption)
end

--- A picture as the painter left it for the page: JPEGs for light and dark, their words as text over them.
local function shots(chapter, sheet, image)
    local here = "pictures/" .. chapter .. "/"
    local html = sheet:gsub('(src%a*=")([%w_.-]+)"', function(attribute, name)
        Page.write(here .. name, Page.read(Book.results .. "/" .. chapter .. "/" .. name))
        return attribute .. here .. name .. '"'
    end)
    return (html:gsub('alt=""', function() return 'alt="' .. alternative(image) .. '"' end, 1))
end

--- What the reader types to make the picture: the chapter's program is what ./course run N runs.
function Figures.command(chapter, fields)
    local run = "./course run " .. tonumber(chapter:match("^%d+"))
    local noted = fields and fields.command
    if not noted then return run end
    local program, arguments = noted:match("^(%S+)%s*(.-)%s*$")
    local own = program:match("[^/]*$") == chapter and (arguments == "" or arguments:find("^%-%-out%s+%S+$"))
    return own and run or noted
end

--- What makes a figure move: the module of its chapter, if one was built, copied once.
local function module(page, chapter)
    if not Book.live then return nil end
    if page.modules and page.modules[chapter] ~= nil then return page.modules[chapter] end
    local bytes = Page.read(Book.live .. "/" .. chapter .. ".js", true)
    if bytes then Page.write("live/" .. chapter .. ".js", bytes) end
    page.modules = page.modules or {}
    page.modules[chapter] = bytes ~= nil
    return page.modules[chapter]
end

local function content(page, image, at)             -- html, fields of the .txt; nil after a complaint
    local src = image.src
    local chapter, file = src:match("^([%w_]+)/([%w_.-]+)$")
    if not chapter then chapter, file = page.results or "", src end
    if not chapter:find("^%d%d_") then
        return Report.add(page, at, "picture %s: this page is no chapter: say whose picture, 01_newton/%s", src, src)
    end
    local path = Book.results .. "/" .. chapter .. "/" .. file
    local fields = note((path:gsub("%.%w+$", ".txt")))
    local command = Figures.command(chapter, fields)
    local bytes = Page.read(path, true)
    if not bytes then
        if Numbers.load(chapter).told then return nil end            -- the whole chapter has not been run
        local reason = fields and fields["not drawn"]
        if not reason then
            return Report.add(page, at,
                "picture %s: there is no %s/%s: draw it in the chapter's program, then %s", src, chapter, file, command)
        end
        return nil, nil, {reason = reason:gsub("%.$", ""), command = command}
    end
    local stem = file:match("^(.*)%.png$")
    local sheet = stem and Page.read(Book.results .. "/" .. chapter .. "/" .. stem .. ".page.html", true)
    if sheet then
        local moves = fields and fields.states and module(page, chapter)
        return shots(chapter, sheet, image), command, nil,
            moves and (' data-chapter="%s" data-figure="%s"'):format(chapter, stem) or nil
    end
    if file:find("%.svg$") then
        return chart(page, at, src, bytes), command
    elseif not file:find("%.png$") then
        return Report.add(page, at, "picture %s: a picture is a .png, a chart an .svg", src)
    end
    local width, height = png_size(bytes)
    if not width then return Report.add(page, at, "picture %s: the file is no PNG", src) end
    Page.write("pictures/" .. chapter .. "/" .. file, bytes)
    return ('<img src="pictures/%s/%s" alt="%s" width="%d" height="%d">'):format(chapter, file, alternative(image), width, height), command
end

--- [Verlet](planet.png#verlet) puts the moving figure of this page into a state; without script it leads to the figure.
function Figures.state(page, link, name, state)
    local at = Report.line(page, link.target)
    local id = page.text:match("%(" .. name .. "%.png%){#([%w:_-]+)")
    if not id then
        return Report.add(page, at, "the link %s: this page has no figure %s.png with a label", link.target, name)
    end
    local fields = note(Book.results .. "/" .. (page.results or page.name) .. "/" .. name .. ".txt")
    local states = {}
    for key in (fields and fields.states or ""):gmatch("%S+") do states[key] = true end
    if fields and not states[state] then
        Report.add(page, at, "the link %s: the figure has no state '%s'; %s", link.target, state, Report.names(states, "it does not move"))
    end
    link.target = "#" .. id
    link.attributes["data-figure"], link.attributes["data-state"] = name, state
    return link
end

function Figures.figure(page, image)
    local at = Report.line(page, image.src)
    local html, command, missing, moves = content(page, image, at)
    if moves then image.classes:insert("live") end
    local label = page.labels[image.identifier]
    if missing then
        return pandoc.RawBlock("html", ("<!--missing|%s|%s|%s|%s-->"):format(image.identifier, label and label.text or "",
            Page.escape(missing.reason):gsub("%-%-", "- -"), Page.escape(missing.command)))
    end
    if not html then return {} end
    local style = image.attributes.width and (' style="width:%s"'):format(Page.escape(image.attributes.width)) or ""
    local class = table.concat(image.classes, " ")
    local open = ('<figure%s%s%s%s>%s'):format(image.identifier ~= "" and ' id="' .. Page.escape(image.identifier) .. '"' or "",
        class ~= "" and ' class="' .. class .. '"' or "", moves or "", style, html)
    if #image.caption == 0 then
        if label then Report.add(page, at,
            "picture %s: a numbered figure has a caption that can be read alone", image.src) end
        return pandoc.RawBlock("html", open .. "</figure>")
    end
    local number = label and ('<b class="figno">%s.</b> '):format(label.text:gsub(" ", "\u{a0}")) or ""
    command = image.attributes.command or command
    local tail = label and (' <code class="command">%s</code>'):format(Page.escape(command)) or ""
    return {pandoc.RawBlock("html", open .. "<figcaption>" .. number), pandoc.Plain(image.caption),
            pandoc.RawBlock("html", tail .. "</figcaption></figure>")}
end

local function listed(names)
    return #names < 2 and names[1] or table.concat(names, ", ", 1, #names - 1) .. " and " .. names[#names]
end

--- One quiet note for all that a section could not show for one reason; each keeps its address.
function Figures.gather_missing(body)
    local function section(html)
        local groups = {}
        for id, label, reason, command in html:gmatch("<!%-%-missing|(.-)|(.-)|(.-)|(.-)%-%->") do
            groups[reason] = groups[reason] or {numbers = {}, command = command, ids = {}, count = 0}
            local group = groups[reason]
            group.count = group.count + 1
            local number = label:match("^Figure (.*)$")
            if number then group.numbers[#group.numbers + 1] = number end
            if id ~= "" then group.ids[#group.ids + 1] = id end
        end
        return (html:gsub("<!%-%-missing|.-|.-|(.-)|.-%-%->", function(reason)
            local group = groups[reason]
            if not group then return "" end
            groups[reason] = nil
            local anchors = ""
            for _, id in ipairs(group.ids) do anchors = anchors .. ('<span id="%s"></span>'):format(Page.escape(id)) end
            local one = group.count == 1
            local what = #group.numbers == 0 and (one and "A picture" or group.count .. " pictures")
                or (#group.numbers == 1 and "Figure\u{a0}" or "Figures\u{a0}") .. listed(group.numbers)
            return ('<p class="not-drawn">%s%s %s not drawn here: %s. Once that is mended, <code>%s</code> draws %s.</p>')
                :format(anchors, what, one and "was" or "were", reason, group.command, one and "it" or "them")
        end))
    end
    local out, at = {}, 1
    for start in body:gmatch("()<h2") do
        out[#out + 1], at = section(body:sub(at, start - 1)), start
    end
    out[#out + 1] = section(body:sub(at))
    return table.concat(out)
end

return Figures
