-- A sitting with Neovim's own client: diagnostics, hover, definition. Arguments in the environment: PLCXX, PLCXX_FOLDER (a
-- copy of the sample lathe), PLCXX_EDITORS.
local function main()
  package.path = vim.env.PLCXX_EDITORS .. "/neovim/?.lua;" .. package.path
  require("plcxx").setup({ path = vim.env.PLCXX })
  vim.cmd("filetype on")
  vim.cmd("edit " .. vim.fn.fnameescape(vim.env.PLCXX_FOLDER .. "/fast.plc"))
  assert(vim.bo.filetype == "plc", "filetype " .. vim.bo.filetype)
  local buffer = vim.api.nvim_get_current_buf()
  local function wait(what, condition)
    assert(vim.wait(60000, condition, 20), "waited in vain for " .. what)
  end
  local function client()
    local all = vim.lsp.get_active_clients and vim.lsp.get_active_clients() or vim.lsp.get_clients()
    return all[1]
  end
  wait("the server", function() return client() and client().initialized end)
  assert(client().config.root_dir == vim.env.PLCXX_FOLDER, client().config.root_dir)

  local function request(method, position)
    local answers = vim.lsp.buf_request_sync(buffer, method, {
      textDocument = vim.lsp.util.make_text_document_params(), position = position }, 60000)
    for _, answer in pairs(answers or {}) do
      assert(answer.error == nil, vim.inspect(answer.error))
      return answer.result
    end
    error("no answer to " .. method)
  end
  local line
  for number, text in ipairs(vim.api.nvim_buf_get_lines(buffer, 0, -1, true)) do
    if text:sub(1, 7) == "!KDRV =" then line = number - 1 end
  end
  local hover = request("textDocument/hover", { line = line, character = 2 })
  assert(hover.contents.value:find("contactor of the drives"), hover.contents.value)
  local definition = request("textDocument/definition", { line = line, character = 2 })
  assert(definition[1].uri:find("lathe%.sym$"), definition[1].uri)

  -- What the page says of keys, in the oldest Neovim, too.
  vim.api.nvim_win_set_cursor(0, { line + 1, 2 })
  local tags = vim.lsp.tagfunc("!KDRV", "c")  -- as CTRL-] calls it
  assert(vim.bo.tagfunc:find("lsp.tagfunc") and vim.bo.omnifunc:find("lsp.omnifunc"), vim.bo.tagfunc .. vim.bo.omnifunc)
  assert(#tags > 0 and tags[1].filename:find("lathe%.sym$"), vim.inspect(tags))

  local function errors()
    return vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR })
  end
  assert(#errors() == 0, vim.inspect(errors()))
  vim.api.nvim_buf_set_text(buffer, line, 6, line, 7, { "= =" })
  wait("the error", function() return #errors() > 0 end)
  assert(errors()[1].lnum == line, vim.inspect(errors()[1]))
  vim.api.nvim_buf_set_text(buffer, line, 6, line, 9, { "=" })
  wait("no error", function() return #errors() == 0 end)

  vim.cmd("edit " .. vim.fn.fnameescape(vim.env.PLCXX_FOLDER .. "/lathe.sym"))
  assert(vim.bo.filetype == "nc110", vim.bo.filetype)

  -- A plcxx that is not there is one message, and no error of the file that is opened.
  require("plcxx").setup({ path = vim.env.PLCXX .. "-gone" })
  local said = {}
  vim.notify_once = function(text) table.insert(said, text) end
  vim.cmd("edit " .. vim.fn.fnameescape(vim.env.PLCXX_FOLDER .. "/gone.plc"))
  wait("the message", function() return #said > 0 end)
  assert(said[1]:find("cannot be started"), said[1])
  print("neovim: as it should be\n")
end

local ok, why = xpcall(main, debug.traceback)
if not ok then
  io.stderr:write(tostring(why) .. "\n")
  vim.cmd("cquit 1")
end
vim.cmd("qall!")
