-- plcxx in Neovim (0.7 and newer): its languages, and `plcxx lsp` for them. See docs/editors/neovim.md.
--
--   require("plcxx").setup()                          plcxx is in PATH
--   require("plcxx").setup({ path = "/opt/plcxx/bin/plcxx", options = { ... } })
local M = {}

-- ".plc" belongs to three languages: the server chooses by plcxx.yaml, else by content. A filetype that is the name of a
-- dialect (:set filetype=technol) chooses it for a file without plcxx.yaml.
local extensions = { plc = "plc", sym = "nc110", il = "host50", pst = "prostep", tch = "technol", cld = "hnc", clp = "classicladder" }
local filetypes = { "plc", "nc110", "host50", "prostep", "technol", "hnc", "classicladder" }

local clients = {} -- of Neovim before 0.8, by folder

local function root_of(file)
  local project = vim.fn.findfile("plcxx.yaml", vim.fn.fnamemodify(file, ":p:h") .. ";")
  return vim.fn.fnamemodify(project ~= "" and project or file, ":p:h")
end

local function attach(buffer, options)
  local path = options.path or "plcxx"
  if vim.fn.executable(path) ~= 1 then
    local text = "plcxx was not found: '" .. path .. "' cannot be started. Install plcxx and put it into PATH, or name it: "
      .. "require('plcxx').setup({ path = ... })"
    -- Not within the event: an old Neovim takes an error message there for an error of this file, and shows its stack.
    vim.schedule(function() vim.notify_once(text, vim.log.levels.ERROR) end)
    return
  end
  local config = {
    name = "plcxx",
    cmd = { path, "lsp" },
    root_dir = root_of(vim.api.nvim_buf_get_name(buffer)),
    init_options = options.options,
  }
  if vim.lsp.start then
    vim.lsp.start(config, { bufnr = buffer })
    return
  end
  clients[config.root_dir] = clients[config.root_dir] or vim.lsp.start_client(config)
  vim.lsp.buf_attach_client(buffer, clients[config.root_dir])
  -- From 0.8 on Neovim does it itself.
  vim.bo[buffer].omnifunc = "v:lua.vim.lsp.omnifunc"
  vim.bo[buffer].tagfunc = "v:lua.vim.lsp.tagfunc"
end

function M.setup(options)
  options = options or {}
  local group = vim.api.nvim_create_augroup("plcxx", { clear = true })
  for extension, filetype in pairs(extensions) do
    vim.api.nvim_create_autocmd({ "BufRead", "BufNewFile" }, {
      group = group,
      pattern = { "*." .. extension, "*." .. extension:upper() },
      callback = function(args) vim.bo[args.buf].filetype = filetype end,
    })
  end
  vim.api.nvim_create_autocmd("FileType", {
    group = group,
    pattern = filetypes,
    callback = function(args)
      vim.bo[args.buf].commentstring = args.match == "hnc" and "/*%s*/" or ";%s"
      if vim.bo[args.buf].buftype == "" then attach(args.buf, options) end
    end,
  })
  -- What programs include has names of other languages.
  vim.api.nvim_create_autocmd({ "BufReadPost", "BufNewFile" }, {
    group = group,
    pattern = { "*.inc", "*.h", "plcxx.yaml" },
    callback = function(args)
      if vim.fn.findfile("plcxx.yaml", vim.fn.fnamemodify(args.match, ":p:h") .. ";") ~= "" then attach(args.buf, options) end
    end,
  })
end

return M
