-- Fenced divs: numbered equations and the few boxes that give the pages their rhythm. Any other class is a complaint.
local Boxes = {}

local titles = {                                    -- class -> what stands on the box
    question = "The question", predict = "Predict first", breaks = "What breaks", needs = "What the scene needs",
    exercise = "Exercise", source = "In the source", idea = "The idea", see = "What you should see", goals = "In this chapter",
}
local plain = {pair = true, cards = true, card = true, lead = true}     -- layout without a title

local function open_close(open, content, close)
    local out = pandoc.List {pandoc.RawBlock("html", open)}
    out:extend(content)
    out:insert(pandoc.RawBlock("html", close))
    return out
end

local function errata_links(page, list, at)
    local links = {}
    for id in list:gmatch("[^%s,;]+") do
        if Errata.by_id[id] then
            links[#links + 1] = ('<a class="erratum-link" href="errata.html#%s">%s</a>'):format(id, id)
        else
            Report.add(page, at, "erratum '%s': errata.csv has no such row", id)
        end
    end
    return table.concat(links, " ")
end

local function equation(page, div)
    local label = page.labels[div.identifier]
    local at = Report.line(page, "#" .. div.identifier)
    local math = #div.content == 1 and div.content[1].content
    if not math or #math ~= 1 or math[1].t ~= "RawInline" or not math[1].text:find('class="tex display"', 1, true) then
        Report.add(page, at, "equation %s holds one $$…$$ and nothing else", div.identifier)
        return {}
    end
    local number, extra = label.text, ""
    if div.attributes.erratum then
        local links = errata_links(page, div.attributes.erratum, at)
        local printed = div.classes:includes("printed")
        extra = ('<span class="corrects">%s %s</span>'):format(printed and "as printed," or "corrects", links)
    end
    local class = div.classes:includes("printed") and "equation printed" or "equation"
    return pandoc.RawBlock("html", ('<div class="%s" id="%s"><div class="formula">%s</div>'):format(class, div.identifier, math[1].text)
        .. ('<div class="eqno"><a href="#%s">%s</a>%s</div></div>'):format(div.identifier, number, extra))
end

--- The reader's command, and below it one body in a fold; the open edition shows the body in its listing instead.
local function exercise_end(page, at, number)
    local path = page.quoted[number]
    if not path then
        Report.add(page, at, "exercise %s stands where its code is: quote a region that holds it on this page", number)
        return {}
    end
    local out = pandoc.List {pandoc.RawBlock("html",
        ('<p class="task"><code>./course check %s</code></p>'):format(number))}
    if Book.exercises[number].open then return out end
    local region = Regions.take(page, path .. "#" .. number)
    if not region then return out end
    out:extend {Page.only("learner", '<details class="body"><summary>One body that passes</summary>', true),
        pandoc.CodeBlock(region.text, {class = Regions.language(path)}), Page.only("learner", "</details>", false)}
    return out
end

local function exercise_list(page)
    local items = {}
    for _, e in ipairs(page.exercises) do
        items[#items + 1] = ('<li><a href="#ex:%s">Exercise %s</a> · %s</li>'):format(e.id, e.id, Page.escape(e.title))
    end
    return pandoc.RawBlock("html", '<ul class="exercise-list">' .. table.concat(items) .. "</ul>")
end

local function box(page, div, class)
    local at = Report.line(page, div.identifier ~= "" and "#" .. div.identifier or class)
    local title = titles[class]
    if class == "exercise" then
        local number = div.identifier:match("^ex:(%d+%.%d+)$")
        if not number then
            Report.add(page, at, "an exercise says which one it is: ::: {.exercise #ex:1.3}")
        else
            title = title .. " " .. number .. (Book.exercises[number].open and ": a worked example" or ": yours")
            div.content:extend(exercise_end(page, at, number))
        end
    end
    local label = "<b>" .. title .. "</b>"
    if div.attributes.title then label = label .. " · " .. Page.escape(div.attributes.title) end
    if div.attributes.erratum then label = label .. " " .. errata_links(page, div.attributes.erratum, at) end
    local id = div.identifier ~= "" and (' id="%s"'):format(div.identifier) or ""
    return open_close(('<aside class="box %s"%s><p class="label">%s</p>'):format(class, id, label), div.content, "</aside>")
end

function Boxes.div(page, div)
    if div.identifier:find("^eq:") then return equation(page, div) end
    local class = div.classes[1]
    if not class then return nil end
    if class == "reveal" then
        local title = Page.escape(div.attributes.title or "What happens")
        return open_close('<details><summary>' .. title .. '</summary><div class="answer">', div.content, "</div></details>")
    elseif class == "exercises" then
        return exercise_list(page)
    elseif class == "chapters" then
        return Page.chapter_list()
    elseif class == "errata-table" then
        return Errata.rows(page)
    elseif titles[class] then
        return box(page, div, class)
    elseif plain[class] then
        return open_close(('<div class="%s">'):format(class), div.content, "</div>")
    end
    local known = {reveal = true, chapters = true, exercises = true, ["errata-table"] = true}
    for name in pairs(titles) do known[name] = true end
    for name in pairs(plain) do known[name] = true end
    Report.add(page, Report.line(page, class), "there is no box '%s' (%s)", class, Report.names(known))
    return {}
end

return Boxes
