//! `ladder mcp`: what the other commands do, for assistants, over the Model Context Protocol on stdin and stdout.
//!
//! A call of a tool becomes the arguments of a command ([`tools`], [`commands`]), which runs as a process of its own ([`child`]), so that
//! nothing that a program does can keep the server from answering. What it prints comes back in pages ([`pages`]). Only simulations that go
//! on from call to call ([`sessions`]) are kept here. Every path is within the folders that the client has opened ([`roots`]).

mod child;
mod commands;
mod given;
mod pages;
mod prompts;
mod resources;
mod roots;
mod sessions;
mod tools;

use crate::outcome::{Failure, Outcome};
use clap::Args;
use given::Given;
use pages::Answer;
use rmcp::handler::server::ServerHandler;
use rmcp::model::{
    CallToolRequestParams, CallToolResponse, CallToolResult, ContentBlock, ErrorData, GetPromptRequestParams,
    GetPromptResponse, Implementation, ListPromptsResult, ListResourceTemplatesResult, ListResourcesResult,
    ListToolsResult, PaginatedRequestParams, ReadResourceRequestParams, ReadResourceResponse,
    ServerCapabilities, ServerConfig,
};
use rmcp::service::{NotificationContext, RequestContext, RoleServer, ServiceExt};
use roots::Roots;
use sessions::Sessions;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

const EXAMPLES: &str = "\
Examples:
  ladder mcp          what an assistant starts, in the folder of the programs
  ladder mcp plant    programs are in this folder

An assistant's settings name the program and its argument, often as

  { \"mcpServers\": { \"ladder\": { \"command\": \"ladder\", \"args\": [\"mcp\"] } } }

Exit status: 0 the assistant ended, 2 the arguments cannot be used.";

/// Be a server of tools for assistants, over stdin and stdout
///
/// Assistants start this; it speaks the Model Context Protocol. They check, draw, run, test and prove programs with it. It reads and writes
/// nothing outside of the folders that the client has opened, writes only where a tool is asked to, and needs no network.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The folders of the programs, for a client that names none [default: this folder]
    folders: Vec<PathBuf>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let server = Server {
        roots: Arc::new(Mutex::new(Roots::of_arguments(&arguments.folders)?)),
        sessions: Arc::default(),
    };
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()
        .map_err(|error| Failure::new(format!("the server cannot begin: {error}")))?;
    let ended = runtime.block_on(async {
        // A client that goes before it has greeted has ended, too.
        let Ok(running) = server.serve(rmcp::transport::stdio()).await else {
            return Ok(());
        };
        running.waiting().await.map(|_| ())
    });
    // A read of stdin cannot be given up.
    runtime.shutdown_background();
    ended.map_err(|error| Failure::new(format!("the server has stopped: {error}")))?;
    Ok(Outcome::Fine)
}

/// What answers a client.
struct Server {
    roots: Arc<Mutex<Roots>>,
    sessions: Arc<Mutex<Sessions>>,
}

impl Server {
    /// Asks the client for its folders, once, if it has such.
    #[allow(
        deprecated,
        reason = "clients of the protocol's earlier versions name their folders so"
    )]
    async fn learn_roots(&self, context: &RequestContext<RoleServer>) {
        let is_known = lock(&self.roots).is_of_client();
        let peer = &context.peer;
        let names_roots = peer
            .peer_info()
            .is_some_and(|info| info.capabilities.roots.is_some());
        if is_known || !names_roots {
            return;
        }
        let listed = tokio::time::timeout(roots::PATIENCE, peer.list_roots()).await;
        if let Ok(Ok(listed)) = listed {
            let addresses: Vec<String> = listed.roots.into_iter().map(|root| root.uri).collect();
            lock(&self.roots).become_those_of(&addresses);
        }
    }

    async fn called(&self, name: &str, given: Given) -> Result<Answer, String> {
        let tool = tools::by_name(name).ok_or_else(|| format!("there is no tool `{name}`"))?;
        tool.check(&given)?;
        if tool.name == "session" {
            let (sessions, roots) = (Arc::clone(&self.sessions), Arc::clone(&self.roots));
            let job = move || {
                let roots = lock(&roots).clone();
                lock(&sessions).call(&given, &roots)
            };
            let done = tokio::task::spawn_blocking(job).await;
            return done.unwrap_or_else(|_| Err("the simulation has failed: start it again".to_owned()));
        }
        let roots = lock(&self.roots).clone();
        commands::run(tool, &given, &roots).await
    }
}

fn lock<T>(shared: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

impl ServerHandler for Server {
    fn get_info(&self) -> ServerConfig {
        let capabilities = ServerCapabilities::builder()
            .enable_tools()
            .enable_resources()
            .enable_prompts()
            .build();
        ServerConfig::new(capabilities)
            .with_server_info(Implementation::new("ladder", env!("CARGO_PKG_VERSION")))
            .with_instructions(resources::INSTRUCTIONS)
    }

    async fn list_tools(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListToolsResult, ErrorData> {
        Ok(ListToolsResult::with_all_items(
            tools::TOOLS.iter().map(tools::Tool::described).collect(),
        ))
    }

    async fn call_tool(
        &self,
        request: CallToolRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<CallToolResponse, ErrorData> {
        self.learn_roots(&context).await;
        let given = Given(request.arguments.unwrap_or_default());
        let result = match self.called(&request.name, given).await {
            Ok(answer) => answer.result(),
            Err(why) => CallToolResult::error(vec![ContentBlock::text(why)]),
        };
        Ok(result.into())
    }

    async fn list_resources(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListResourcesResult, ErrorData> {
        Ok(ListResourcesResult::with_all_items(resources::all()))
    }

    async fn list_resource_templates(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListResourceTemplatesResult, ErrorData> {
        Ok(ListResourceTemplatesResult::with_all_items(resources::templates()))
    }

    async fn read_resource(
        &self,
        request: ReadResourceRequestParams,
        _: RequestContext<RoleServer>,
    ) -> Result<ReadResourceResponse, ErrorData> {
        let read = resources::read(&request.uri).await;
        let read = read.map_err(|why| ErrorData::resource_not_found(why, None))?;
        Ok(read.into())
    }

    async fn list_prompts(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListPromptsResult, ErrorData> {
        Ok(ListPromptsResult::with_all_items(prompts::all()))
    }

    async fn get_prompt(
        &self,
        request: GetPromptRequestParams,
        _: RequestContext<RoleServer>,
    ) -> Result<GetPromptResponse, ErrorData> {
        let given = Given(request.arguments.unwrap_or_default());
        let prompt = prompts::of(&request.name, &given);
        let prompt = prompt.map_err(|why| ErrorData::invalid_params(why, None))?;
        Ok(prompt.into())
    }

    async fn on_roots_list_changed(&self, _: NotificationContext<RoleServer>) {
        lock(&self.roots).ask_again();
    }
}
