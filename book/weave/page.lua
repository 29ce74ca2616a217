-- Files in and out, and the frame round a page: navigation, contents, previous and next.
local Page = {}

function Page.read(path, optional)
    local f = io.open(path, "rb")
    local text = f and f:read("a")                  -- a folder opens and cannot be read
    if f then f:close() end
    if not text and not optional then
        io.stderr:write("book: cannot read " .. path .. "\n")
        os.exit(1)
    end
    return text
end

local made = {}
function Page.write(name, bytes)
    local folder = name:match("^(.*)/[^/]*$")
    if folder and not made[folder] then
        pandoc.system.with_working_directory(Book.out, function() os.execute("mkdir -p '" .. folder .. "'") end)
        made[folder] = true
    end
    local f, why = io.open(Book.out .. "/" .. name, "wb")
    if not f then io.stderr:write("book: cannot write " .. why .. "\n"); os.exit(1) end
    f:write(bytes)
    f:close()
end

function Page.escape(text)
    return (text:gsub("[&<>\"]", {["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;"}))
end

local template
local function fill(values)
    template = template or Page.read(Book.here .. "/style/template.html")
    return (template:gsub("{{(%w+)}}", function(name) return values[name] or "" end))
end

--- Where a page stands: 03_forces is chapter 3; 03a_damping is its side road 3A and uses chapter 3's results;
--- 06a_tops is chapter 6's second half, a page of its own. 00_toolbox is numbered and no chapter.
function Page.place(page)
    local digits, letter = page.name:match("^(%d%d)(%l?)_")
    if not digits then return end
    page.chapter = tonumber(digits)
    page.side = letter ~= "" and letter:upper() or nil
    page.half = page.side == "A" and page.chapter >= 6         -- 06a, 07a go on where 06, 07 end: no way round
    page.number = page.chapter .. (page.side or "")
    page.results = page.name
    for name in os.getenv("BOOK_LIST"):gmatch("%S+") do
        if name:find("^" .. digits .. "_") then page.results = name end
    end
end

--- What stands above a numbered page's title, and what a reference to the whole page says; nil for the others.
function Page.kicker(page)
    if page.half then return ("Chapter %d · second half"):format(page.chapter) end
    if page.side then return "Side road " .. page.number end
    return page.chapter and page.chapter > 0 and "Chapter " .. page.chapter or nil
end

local function is_chapter(page) return page.chapter and page.chapter > 0 and not page.side end

--- HTML that only one edition has: "learner" or "open".
function Page.only(edition, html, begins)
    local mark = ("<!--%s%s-->"):format(begins and "" or "/", edition)
    return pandoc.RawBlock("html", begins and mark .. html or html .. mark)
end

--- A woven page as an edition shows it. The open one has every body in its listing, every answer unfolded.
local function edition_of(html, edition)
    local other = edition == "open" and "learner" or "open"
    html = html:gsub("<!%-%-" .. other .. "%-%->.-<!%-%-/" .. other .. "%-%->", "")
    html = html:gsub("<!%-%-/?" .. edition .. "%-%->", "")
    if edition == "open" then
        html = html:gsub("<details([ >])", "<details open%1")
        html = html:gsub('(%s[hs]re?[fc]=")(%l+/)', "%1../%2"):gsub('(%ssrcset=")(%l+/)', "%1../%2")
    end
    return html
end

local function contents_of(page)
    if #page.contents == 0 then return "" end
    local items = {}
    for _, entry in ipairs(page.contents) do
        local title = pandoc.write(pandoc.Pandoc {pandoc.Plain(entry.content)}, "html5", {wrap_text = "wrap-none"})
        items[#items + 1] = ('<li><a href="#%s">%s%s</a></li>'):format(entry.id,
            entry.number and '<span class="secno">' .. entry.number .. "</span> " or "", title)
    end
    return "<ol>" .. table.concat(items) .. "</ol>"
end

local chapters
--- All chapters, those to come included, as index.md's header names them: "chapters:", then lines
--- "- 4 Rotations. What it is about."
function Page.chapters()
    if chapters then return chapters end
    local list, by_number = {}, {}
    for _, page in ipairs(Book.pages) do if is_chapter(page) then by_number[page.chapter] = page end end
    for _, item in ipairs(Book.pages[1].doc.meta.chapters or {}) do
        local number, title, about = pandoc.utils.stringify(item):match("^(%d+)%s+([^.]+)%.%s*(.*)$")
        if number then
            list[#list + 1] = {number = number, title = title, about = about, page = by_number[tonumber(number)]}
        else
            Report.add(Book.pages[1], Report.line(Book.pages[1],
                "chapters:"), "a line under chapters: is '- 4 Title. What it is about.' without a colon")
        end
    end
    chapters = list
    return list
end

--- A chapter's question: the last sentence of its first box of that kind that asks.
local function question_of(page)
    local asked
    page.doc:walk {Div = function(d)
        if d.classes[1] ~= "question" or asked then return end
        for sentence in pandoc.utils.stringify(d):gmatch("[^.?!]+[.?!]") do
            if sentence:sub(-1) == "?" then asked = sentence:match("^%s*(.*)$") end
        end
    end}
    return asked
end

--- How long reading and exercises take, in minutes; HOWTO.md says how it is reckoned. Asked before the page is woven.
--- page.length gets what `lengths.csv` says of it: words, numbered figures, minutes, and those before its first exercise.
function Page.minutes(page)
    if page.minutes then return page.minutes end
    local reading, exercises, words, figures, first = 0, 0, 0, 0, nil
    page.doc:walk {
        traverse = "topdown",                               -- in the order of the page
        Str = function(s) if s.text:find("%a") then words = words + 1; reading = reading + 1 / 200 end end,
        Image = function(i)
            reading = reading + 1 / 2
            if i.identifier ~= "" then figures = figures + 1 end
        end,
        Math = function(m) if m.mathtype == "DisplayMath" then reading = reading + 1 / 3 end end,
        Div = function(d)
            if d.classes:includes("predict") then reading = reading + 1 / 2 end
            if d.classes:includes("exercise") then first = first or reading end
        end,
        CodeBlock = function(b)
            if not b.attributes.region then return end
            local lines, bodies = Regions.lengths(b.attributes.region)
            reading = reading + lines / 30
            for _, body in pairs(bodies) do exercises = exercises + 3 + body end
        end,
    }
    local function round(minutes) return 5 * math.ceil(minutes / 5 - 0.2) end
    page.minutes = {reading = round(reading), exercises = round(exercises)}
    page.length = {words, figures, page.minutes.reading, page.minutes.exercises, first and ("%.1f"):format(first) or ""}
    return page.minutes
end

function Page.write_lengths()
    local lines = {"page,words,figures,minutes of reading,minutes of exercises,minutes before the first exercise"}
    for _, page in ipairs(Book.pages) do
        if page.chapter then lines[#lines + 1] = page.file .. "," .. table.concat(page.length, ",") end
    end
    Page.write("lengths.csv", table.concat(lines, "\n") .. "\n")
end

local function hours_of(page)
    local minutes = Page.minutes(page)
    local halves = math.max(1, math.floor((minutes.reading + minutes.exercises) / 30 + 0.5))
    local whole = halves // 2
    return "about " .. (whole > 0 and whole or "") .. (halves % 2 == 1 and "½" or "") .. (halves <= 2 and " hour" or " hours")
end

--- Its picture with the class `thumb`, else its first, small; nothing where none was drawn.
local function thumbnail_of(page)
    local found = ""
    local chosen = page.text:match("%(([%w_]+)%.png%){[^}]*%.thumb[^}]*}")
    page.doc:walk {Image = function(i)
        local stem = found == "" and i.src:match("^([%w_]+)%.png$")
        if not stem or (chosen and stem ~= chosen) then return end
        local from, to = Book.results .. "/" .. page.results .. "/" .. stem, "pictures/" .. page.results .. "/" .. stem
        local light, dark = Page.read(from .. ".1.jpg", true), Page.read(from .. ".1.dark.jpg", true)
        if not light or not dark then return end
        Page.write(to .. ".1.jpg", light)
        Page.write(to .. ".1.dark.jpg", dark)
        found = ('<picture><source media="screen and (prefers-color-scheme: dark)" srcset="%s.1.dark.jpg"><img src="%s.1.jpg" alt=""></picture>')
            :format(to, to)
    end}
    return found
end

--- The chapters for the front page: a card each, with picture, question and time.
function Page.chapter_list()
    local items = {}
    for _, c in ipairs(Page.chapters()) do
        local page, title = c.page, Page.escape(c.page and c.page.title or c.title)
        local asked = c.about:match("^[^.?]+%?") or page and question_of(page)
        local about = c.about:gsub("^[^.?]+%?%s*", "")
        local lines = {page and thumbnail_of(page) or "",
            ('<span class="name"><span class="no">%s</span> %s%s</span>'):format(c.number, title, page and "" or " <i>(coming)</i>"),
            asked and ('<span class="asks">%s</span>'):format(Page.escape(asked)) or "",
            ('<span class="about">%s</span>'):format(Page.escape(about)),
            page and ('<span class="time">%s</span>'):format(hours_of(page)) or ""}
        local inside = table.concat(lines)
        items[#items + 1] = page and ('<li class="here"><a href="%s.html">%s</a></li>'):format(page.name, inside)
            or '<li class="coming">' .. inside .. "</li>"
    end
    return pandoc.RawBlock("html", '<ol class="chapter-list">' .. table.concat(items) .. "</ol>")
end

local function navigation(current)
    local items = {}
    local function add(class, html) items[#items + 1] = ('<li class="%s">%s</li>'):format(class, html) end
    local function entry(page)
        local number = is_chapter(page) and ('<span class="no">%d</span>'):format(page.chapter) or ""
        local here = page == current
        local class = page.side and "side-road" or is_chapter(page) and "chapter" or "extra"
        add(class .. (here and " here" or ""),
            ('<a href="%s.html"%s>%s%s</a>%s'):format(page.name, here and ' aria-current="page"' or "", number,
                Page.escape(page.title), here and page.chapter and contents_of(page) or ""))
    end
    -- side roads show below their chapter while the reader is in it
    for _, page in ipairs(Book.pages) do
        if page.chapter and (not page.side or page.half or page.chapter == current.chapter) then entry(page) end
    end
    for _, c in ipairs(Page.chapters()) do
        if not c.page then
            add("chapter coming", ('<span><span class="no">%s</span>%s</span>'):format(c.number, Page.escape(c.title)))
        end
    end
    for _, page in ipairs(Book.pages) do if not page.chapter and page.name ~= "index" then entry(page) end end
    return '<ol class="pages">' .. table.concat(items) .. "</ol>"
end

local function turn(page, class, word)
    if not page then return "<span></span>" end
    local title = page.number and page.number ~= "0" and page.number .. " · " .. page.title or page.title
    return ('<a class="%s" href="%s.html"><small>%s</small>%s</a>'):format(class, page.name, word, Page.escape(title))
end

local function aside(page) return page.side and not page.half end

--- The pages before and after: the main road passes its side roads by; a side road leads back to its chapter.
local function neighbours(page)
    local index, before, after, main
    for i, p in ipairs(Book.pages) do if p == page then index = i end end
    for i, p in ipairs(Book.pages) do
        if aside(page) and p.number == tostring(page.chapter) then main = p end
        if i < index and not aside(p) then before = p end
        if i > index and not after and (aside(page) or not aside(p)) then after = p end
    end
    return main or before, after
end

--- What stands at the head of each printed page.
function Page.running(page)
    local number = page.number and page.number ~= "0" and page.number .. " · " or ""
    return (page.name == "index" and "" or number .. page.title .. "   |   ") .. "Game Physics in a Nutshell"
end

local search = [[<form class="search" role="search" hidden><input type="search" aria-label="Search the book" placeholder="Search the book" autocomplete="off">
<p role="status"></p><ol></ol></form>]]                -- shown by book.js, which makes it work

function Page.fill(page, edition)
    local before, after = neighbours(page)
    local kicker = Page.kicker(page)
    local other = edition == "open" and "../" or "open/"
    local word = edition == "open" and 'This is the open edition, for print and for teachers: bodies and answers are shown. <a href="%s%s.html">The learner’s edition</a>'
        or 'For print and for teachers: <a href="%s%s.html">the open edition</a>, with every body and answer shown.'
    local html = fill {
        title = Page.escape(page.name == "index" and page.title or page.title .. " · Game Physics in a Nutshell"),
        base = "", class = (page.chapter and "chapter" or page.name), nav = navigation(page), body = page.body,
        kicker = kicker and ('<p class="kicker">%s</p>'):format(kicker) or "",
        previous = turn(before, "previous", aside(page) and "Back to" or "Before"), next = turn(after, "next", "Next"),
        edition = "@edition@", search = search,
        script = '<script src="book.js" defer></script>' .. (page.modules and '<script src="live/live.js" defer></script>' or ""),
        running = (Page.running(page):gsub('["\\<>&]', "")),
    }
    html = edition_of(html, edition)
    if edition == "open" then
        html = html:gsub('href="(%l+%.css)"', 'href="../%1"'):gsub('src="(%l+%.js)"', 'src="../%1"')
        html = html:gsub('data%-edition=""', 'data-edition="open/"')
    end
    return (html:gsub("@edition@", function() return word:format(other, page.name) end))
end

--- A quoted source file as a page of its own, lines numbered, so that the link under each listing opens from disk.
function Page.write_source(path)
    local text = Book.sources[path]:gsub("\n$", "")
    local block = pandoc.CodeBlock(text, {id = "L", class = Regions.language(path) .. " numberLines lineAnchors"})
    local code = pandoc.write(pandoc.Pandoc {block}, "html5")
    code = code:gsub('<a href="(#L%-%d+)"[^>]*></a>', '<a href="%1" tabindex="-1" aria-hidden="true"></a>')  -- a line's number
    local up = "../" .. path:gsub("[^/]+", ".."):gsub("%.%.$", "")
    Page.write("source/" .. path .. ".html", fill {
        title = Page.escape(path), base = up, class = "source", body = "<h1>" .. Page.escape(path) .. "</h1>" .. code,
        nav = ('<ol class="pages"><li class="extra"><a href="%sindex.html">Back to the book</a></li></ol>'):format(up)})
end

return Page
