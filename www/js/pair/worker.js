// The worker of the page that maps one region to another.

import init from "../../pkg/index.js";
import { serveJobs } from "../common/serve.js";
import { RegionsPipeline } from "./pipeline.js";

serveJobs(new RegionsPipeline(), init);
