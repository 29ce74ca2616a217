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
    for _, page in ipairs(Book.pages) do if page.chapter then by_number[page.chapter] = page end end
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

--- The chapters with what they are about, for the front page.
function Page.chapter_list()
    local items = {}
    for _, c in ipairs(Page.chapters()) do
        local title = Page.escape(c.page and c.page.title or c.title)
        local name = c.page and ('<a href="%s.html">%s</a>'):format(c.page.name, title) or title .. " <i>(coming)</i>"
        items[#items + 1] = ('<li class="%s"><span class="no">%s</span><div><b>%s</b> %s</div></li>')
            :format(c.page and "here" or "coming", c.number, name, Page.escape(c.about))
    end
    return pandoc.RawBlock("html", '<ol class="chapter-list">' .. table.concat(items) .. "</ol>")
end

local function navigation(current)
    local items = {}
    local function add(class, html) items[#items + 1] = ('<li class="%s">%s</li>'):format(class, html) end
    local function entry(page)
        local number = page.chapter and ('<span class="no">%d</span>'):format(page.chapter) or ""
        local here = page == current
        add((page.chapter and "chapter" or "extra") .. (here and " here" or ""),
            ('<a href="%s.html"%s>%s%s</a>%s'):format(page.name, here and ' aria-current="page"' or "", number,
                Page.escape(page.title), here and page.chapter and contents_of(page) or ""))
    end
    for _, page in ipairs(Book.pages) do if page.chapter then entry(page) end end
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
    local title = page.chapter and page.chapter .. " · " .. page.title or page.title
    return ('<a class="%s" href="%s.html"><small>%s</small>%s</a>'):format(class, page.name, word, Page.escape(title))
end

function Page.fill(page)
    local index
    for i, p in ipairs(Book.pages) do if p == page then index = i end end
    return fill {
        title = Page.escape(page.name == "index" and page.title or page.title .. " · Game Physics in a Nutshell"),
        base = "", class = page.chapter and "chapter" or page.name, nav = navigation(page), body = page.body,
        kicker = page.chapter and ('<p class="kicker">Chapter %d</p>'):format(page.chapter) or "",
        previous = turn(Book.pages[index - 1], "previous", "Before"), next = turn(Book.pages[index + 1], "next", "Next"),
    }
end

--- A quoted source file as a page of its own, lines numbered, so that the link under each listing opens from disk.
function Page.write_source(path)
    local text = Book.sources[path]:gsub("\n$", "")
    local block = pandoc.CodeBlock(text, {id = "L", class = Regions.language(path) .. " numberLines lineAnchors"})
    local code = pandoc.write(pandoc.Pandoc {block}, "html5")
    local up = "../" .. path:gsub("[^/]+", ".."):gsub("%.%.$", "")
    Page.write("source/" .. path .. ".html", fill {
        title = Page.escape(path), base = up, class = "source", body = "<h1>" .. Page.escape(path) .. "</h1>" .. code,
        nav = ('<ol class="pages"><li class="extra"><a href="%sindex.html">Back to the book</a></li></ol>'):format(up)})
end

return Page
