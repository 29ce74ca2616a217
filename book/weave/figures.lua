-- Figures: pictures (.png, copied) and charts (.svg, put into the page, so that tooltips and dark mode work).
--   ![Caption.](planet.png){#fig:planet}     alone in its paragraph; another chapter's: 03_forces/chain.png
--   attributes: command="…" (else the picture's .txt says it), alt="…", width=60%
-- A picture that is not there though its .txt is was declared and could not be drawn: the page says so in its place.
local Figures = {}
local charts = 0

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

--- An SVG made fit for standing in a page with others: no prolog, ids and style rules of its own.
local function inline_svg(page, at, src, svg)
    charts = charts + 1
    local prefix = "chart" .. charts
    svg = svg:gsub("^%s*<%?xml.-%?>", ""):gsub("<!DOCTYPE.->", ""):gsub("<!%-%-.-%-%->", "")
    if svg:find("<script") then Report.add(page, at, "the chart " .. src .. " holds a script") end
    local ids = {}
    for id in svg:gmatch("%sid=['\"]([^'\"]+)['\"]") do ids[id] = true end
    local function own(id) return ids[id] and prefix .. "-" .. id or id end
    svg = svg:gsub("(%sid=['\"])([^'\"]+)", function(a, id) return a .. own(id) end)
             :gsub("url%(#([^)]+)%)", function(id) return "url(#" .. own(id) .. ")" end)
             :gsub("(href=['\"]#)([^'\"]+)", function(a, id) return a .. own(id) end)
             :gsub("(aria%-%l+=['\"])([%w_ -]+)(['\"])", function(a, list, b)
                 return a .. list:gsub("%S+", own) .. b end)
    -- Rules of one chart must not reach another: each selector gets the chart's own id in front.
    svg = svg:gsub("<style>(.-)</style>", function(css)
        css = css:gsub("<!%[CDATA%[", ""):gsub("%]%]>", "")
        return "<style>" .. css:gsub("([^{}]+)(%b{})", function(selector, body)
            if selector:find("^%s*@") then
                return selector .. "{" .. body:sub(2, -2):gsub("([^{}]+)(%b{})", function(s, b) return Figures.scope(s, prefix, ids) .. b end) .. "}"
            end
            return Figures.scope(selector, prefix, ids) .. body
        end) .. "</style>"
    end)
    return (svg:gsub("<svg", function() return ('<svg data-chart="%s"'):format(prefix) end, 1))
end

function Figures.scope(selector, prefix, ids)
    local root = ('svg[data-chart="%s"]'):format(prefix)
    local out = {}
    for s in selector:gmatch("[^,]+") do
        s = s:match("^%s*(.-)%s*$")
        s = s:gsub("#([%w_-]+)", function(id) return "#" .. (ids[id] and prefix .. "-" .. id or id) end)
        if s:find("^svg%f[^%w_-]") then out[#out + 1] = root .. s:sub(4)        -- svg, svg.chart, svg text
        elseif s == ":root" then out[#out + 1] = root
        elseif s:find("^%.chart%f[^%w_-]") then out[#out + 1] = root .. s
        else out[#out + 1] = root .. " " .. s end
    end
    return table.concat(out, ",")
end

local function content(page, image, at)             -- html, fields of the .txt; nil after a complaint
    local src = image.src
    local chapter, file = src:match("^([%w_]+)/([%w_.-]+)$")
    if not chapter then chapter, file = page.name, src end
    if not chapter:find("^%d%d_") then
        return Report.add(page, at, ("picture %s: this page is no chapter: say whose picture, 01_newton/%s"):format(src, src))
    end
    local path = Book.results .. "/" .. chapter .. "/" .. file
    local fields = note((path:gsub("%.%w+$", ".txt")))
    local command = fields and fields.command or ("./course run " .. tonumber(chapter:match("^%d+")))
    local bytes = Page.read(path, true)
    if not bytes then
        if not file:find("%.png$") or not fields then
            return Report.add(page, at, ("picture %s: there is no %s/%s: draw it in the chapter's program, then %s"):format(src, chapter, file, command))
        end
        local reason = fields.reason or fields["not drawn"] or fields.missing or "no OpenGL on this machine"
        return ('<div class="not-drawn"><b>%s was not drawn:</b> %s. Once that is mended, <code>%s</code> draws it.</div>')
            :format(Page.escape(src), Page.escape((reason:gsub("%.$", ""))), Page.escape(command)), command
    end
    if file:find("%.svg$") then
        return '<div class="chart">' .. inline_svg(page, at, src, bytes) .. "</div>", command
    elseif not file:find("%.png$") then
        return Report.add(page, at, ("picture %s: a picture is a .png, a chart an .svg"):format(src))
    end
    local width, height = png_size(bytes)
    if not width then return Report.add(page, at, ("picture %s: the file is no PNG"):format(src)) end
    Page.write("pictures/" .. chapter .. "/" .. file, bytes)
    local alt = image.attributes.alt or pandoc.utils.stringify(image.caption)
    return ('<img src="pictures/%s/%s" alt="%s" width="%d" height="%d">'):format(chapter, file, Page.escape(alt), width, height), command
end

function Figures.figure(page, image)
    local at = Report.line(page, image.src)
    local html, command = content(page, image, at)
    if not html then return {} end
    local label = page.labels[image.identifier]
    local style = image.attributes.width and (' style="width:%s"'):format(Page.escape(image.attributes.width)) or ""
    local class = table.concat(image.classes, " ")
    local open = ('<figure%s%s%s>%s'):format(image.identifier ~= "" and ' id="' .. Page.escape(image.identifier) .. '"' or "",
        class ~= "" and ' class="' .. class .. '"' or "", style, html)
    if #image.caption == 0 then
        if label then Report.add(page, at, ("picture %s: a numbered figure has a caption that can be read alone"):format(image.src)) end
        return pandoc.RawBlock("html", open .. "</figure>")
    end
    local number = label and ('<b class="figno">%s.</b> '):format(label.text:gsub(" ", "\u{a0}")) or ""
    command = image.attributes.command or command
    local tail = label and (' <code class="command">%s</code>'):format(Page.escape(command)) or ""
    return {pandoc.RawBlock("html", open .. "<figcaption>" .. number), pandoc.Plain(image.caption),
            pandoc.RawBlock("html", tail .. "</figcaption></figure>")}
end

return Figures
