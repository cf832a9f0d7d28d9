//! `textDocument/signatureHelp`.

use std::sync::Arc;

use ladder_ide::Signature;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    ParameterInformation, ParameterLabel, SignatureHelp, SignatureHelpOptions, SignatureHelpParams,
    SignatureHelpTriggerKind, SignatureInformation,
};

use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, markup, session::agreed::Agreed, session::shared::Shared};

/// What the server offers.
pub(crate) fn options() -> SignatureHelpOptions {
    SignatureHelpOptions {
        trigger_characters: Some(["(", ","].map(str::to_owned).to_vec()),
        retrigger_characters: Some(["=", ">"].map(str::to_owned).to_vec()),
        ..SignatureHelpOptions::default()
    }
}

pub(crate) async fn signature_help(
    shared: &Arc<Shared>,
    params: SignatureHelpParams,
) -> Result<Option<SignatureHelp>> {
    let place = params.text_document_position_params;
    let Some(revision) = shared.documents.get(place.text_document.uri.as_str()) else {
        return Ok(None);
    };
    let agreed = shared.agreed();
    let asked = params
        .context
        .is_none_or(|context| context.trigger_kind == SignatureHelpTriggerKind::INVOKED);
    blocking(&*shared.host, move |_| {
        let offset = revision.offset(convert::our_position(place.position));
        let (context, _) = revision.first_context()?;
        let help = ladder_ide::signature_help(context, offset)?;
        let active = &help.signatures[help.active];
        // Of a contact or a coil there is nothing to say that is worth the lines that it covers.
        if !asked && active.parameters.len() < 2 {
            return None;
        }
        // One after the last means that none of them is meant.
        let parameter = active.active.unwrap_or(active.parameters.len()) as u32;
        Some(SignatureHelp {
            active_signature: Some(help.active as u32),
            active_parameter: Some(parameter),
            signatures: help
                .signatures
                .into_iter()
                .map(|it| signature(agreed, it))
                .collect(),
        })
    })
    .await
}

fn signature(agreed: Agreed, signature: Signature) -> SignatureInformation {
    let markdown = agreed.signature_markdown;
    let label = &signature.label;
    let parameters = signature
        .parameters
        .into_iter()
        .map(|parameter| ParameterInformation {
            label: if agreed.label_offsets {
                // These count UTF-16 units whatever was agreed for positions.
                let unit = |byte: usize| label[..byte].encode_utf16().count() as u32;
                ParameterLabel::LabelOffsets([unit(parameter.range.start), unit(parameter.range.end)])
            } else {
                ParameterLabel::Simple(label[parameter.range].to_owned())
            },
            documentation: (!parameter.doc.is_empty())
                .then(|| markup::documentation(markdown, parameter.doc)),
        });
    SignatureInformation {
        parameters: Some(parameters.collect()),
        documentation: Some(markup::documentation(markdown, signature.doc)),
        active_parameter: None,
        label: label.clone(),
    }
}
